import { CATALOGUE, DEFORMS, type Entry, FITS, LESSONS, SPACES } from "./list";

/** All figures and lessons, each with a small picture that the program made. */
export function Overview({ missing }: { missing: string | null }) {
  return (
    <div class="overview">
      <header>
        <h1 tabIndex={-1}>Figures</h1>
        {missing !== null && (
          <p role="status" class="missing">
            There is no figure “{missing}”. Here are those there are.
          </p>
        )}
      </header>
      <section aria-labelledby="from-the-paper">
        <h2 id="from-the-paper">Shapes that turn into others</h2>
        <p class="figure-lead">
          The figures and the table of “Linear Fractal Shape Interpolation” by Brandon Burch and John C. Hart
          (Graphics Interface 1997), as pages in which everything moves. All of it is computed here, while you
          look.
        </p>
        <Cards row={CATALOGUE} />
      </section>
      <section aria-labelledby="deformation">
        <h2 id="deformation">Shapes that are bent at every scale</h2>
        <p class="figure-lead">
          The figures of “Fractal Deformation Using Displacement Vectors Based on Extended Iterated Shuffle
          Transformation” by Tadahiro Fujimoto, Yoshio Ohno, Kazunobu Muraoka and Norishige Chiba: pull a
          grid, and every part of the shape answers.
        </p>
        <Cards row={DEFORMS} />
      </section>
      <section aria-labelledby="rough-curves">
        <h2 id="rough-curves">Rough curves from a few maps</h2>
        <p class="figure-lead">
          The figures and tables of “On Approximating Rough Curves With Fractal Functions” by Wayne O.
          Cochran, John C. Hart and Patrick J. Flynn: functions made of copies of themselves, the search for
          their maps, and the outline of a leaf.
        </p>
        <Cards row={FITS} />
      </section>
      <section aria-labelledby="in-space">
        <h2 id="in-space">Shapes in space, moved by their parameters</h2>
        <p class="figure-lead">
          The figures of “IFS Fractal Animation” by Nevin M. Darwish and Reda Abd-El-Wahab, rebuilt, as their
          print is cut off: to turn a shape is to turn its maps, and each frame is a set of parameters.
        </p>
        <Cards row={SPACES} />
      </section>
      <section aria-labelledby="lessons">
        <h2 id="lessons">Eleven lessons</h2>
        <p class="figure-lead">
          One idea a page, in order, for anyone who has never heard of any of this. Each shows a finished
          picture, then asks what you expect before it shows what is so.
        </p>
        <Cards row={LESSONS} />
      </section>
    </div>
  );
}

function Cards({ row }: { row: readonly Entry[] }) {
  return (
    <ul class="cards">
      {row.map(({ id, number, title, about, Thumb }) => (
        <li key={id}>
          <a class="figure-card" href={`#figures/${id}`}>
            <span class="figure-thumb" aria-hidden="true">
              <Thumb />
            </span>
            <span class="figure-number">{number}</span>
            <strong>{title}</strong>
            <span class="about">{about}</span>
          </a>
        </li>
      ))}
    </ul>
  );
}
