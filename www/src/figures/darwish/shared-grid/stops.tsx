import css from "./page.module.css";

/** How far the construction goes, and where nobody knows, or others do. */
export function WhereItStops() {
  return (
    <>
      <p>
        So the answer to the paper’s question has two parts. What two shapes of one grid share, moved by any
        fraction, is always a graph-directed shape: a fraction has finitely many shifts with its denominator
        within reach. Whether one system alone makes it is another question: often the graph shows such a
        system, sometimes there is none of maps that can be undone, as for two points, and in general it is
        open.
      </p>
      <p>Here it stops:</p>
      <ul class={css["ends"]}>
        <li>
          <strong>Shifts that are no fractions.</strong> Then no shift comes back, and there is no end of
          kinds. For Cantor’s set and a shift of itself, Deng, He and Wen (2008) say exactly when what is
          shared is self-similar; for a class of such sets a first part of it is, with powers of the same
          ratio, exactly if the shift may be replaced by a fraction (Pedersen and Phillips 2014).
        </li>
        <li>
          <strong>Fractions with large denominators.</strong> Kinds are as many as shifts that come back and
          differ. Up to 1024 of them, with 8192 pieces in all, are found and drawn here; beyond that it stops,
          and says so.
        </li>
        <li>
          <strong>Bases without a common power.</strong> Thirds and ninths have one grid, as the line by
          ninths shows: two steps are taken at once. Halves and thirds have none. There it is known that
          shapes share little: at most the dimension by which both together exceed the line (Furstenberg’s
          conjecture of 1969, proved by Shmerkin and by Wu in 2019).
        </li>
        <li>
          <strong>Turns and scalings with a common power</strong> commute, and so have a grid, as 1 + i and 2
          with 16 = (1 + i)⁸ = 2⁴. But then a step has as many as 256 digits, and at most 64 are drawn here.
        </li>
        <li>
          <strong>Matrices that do not commute,</strong> and maps of different ratios in one shape: no general
          way is known to Frond.
        </li>
        <li>
          <strong>The dimension</strong> is exact where no two digits of a shape leave the same remainder, for
          then they belong to a tile (Bandt 1991), and else a bound from above.
        </li>
      </ul>
    </>
  );
}
