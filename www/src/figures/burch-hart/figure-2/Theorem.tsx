import { Formula } from "../../kit/frame/formula";
import { tex } from "../../kit/notation/tex";
import { adjacency, ways } from "./adjacency";
import css from "./page.module.css";

interface TheoremProps {
  /** How many pieces there are, and which of them were seen to meet. */
  count: number;
  edges: readonly (readonly [number, number])[];
}

/** What the paper concludes from the graph: its matrix X, and the sum Y of the powers of X. */
export function Theorem({ count, edges }: TheoremProps) {
  const x = adjacency(count, edges);
  const y = ways(x);
  const zero = y.some((row) => row.includes(0));
  return (
    <section class={css["theorem"]} aria-label="Theorem 3">
      <p>
        <strong>Theorem 3</strong> (Deo 1972). Of N pieces let X, the adjacency matrix of Definition 4, have a
        1 where two meet, and on its diagonal, where the algorithm begins with <Formula tex={tex`X = I`} />.
        The entries of <Formula tex={tex`Y = X + X^2 + \dots + X^{N-1}`} /> count the ways from piece to
        piece: the graph is disconnected exactly where one of them is 0.{" "}
        <strong>{zero ? "Here Y has a 0: it is disconnected." : "Here Y has no 0: it is connected."}</strong>{" "}
        By Theorem 2 a shape is in one piece exactly when its overlap graph is connected (Hata 1985). Frond
        joins pieces in sets instead, which says the same and takes no powers.
      </p>
      <div class={css["matrices"]}>
        <Matrix name="X" rows={x} />
        <Matrix name="Y" rows={y} marked />
      </div>
    </section>
  );
}

interface MatrixProps {
  name: string;
  rows: readonly (readonly number[])[];
  /** What is 0 stands out. */
  marked?: boolean;
}

function Matrix({ name, rows, marked = false }: MatrixProps) {
  return (
    <table class={css["matrix"]}>
      <caption>{name}</caption>
      <thead>
        <tr>
          <td />
          {rows.map((_, j) => (
            <th key={j} scope="col">
              {j + 1}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {rows.map((row, i) => (
          <tr key={i}>
            <th scope="row">{i + 1}</th>
            {row.map((value, j) => (
              <td key={j} class={marked && value === 0 ? css["zero"] : ""}>
                {value}
              </td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}
