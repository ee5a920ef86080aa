import type { Intersection3 } from "#wasm/api";
import { Formula } from "../../kit/frame/formula";
import layout from "../../kit/frame/layout.module.css";
import { Table } from "../../kit/frame/table";
import { tex } from "../../kit/notation/tex";
import { MOST_DRAWN } from "../graph/layout";
import { shiftWords, waysOf } from "./meets";
import css from "./product.module.css";
import { MeetGraph } from "./product-graph";

/** Rows of the table of shifts. */
const MOST_ROWS = 12;

/** The product of the two systems: drawn, and as a table. */
export function MeetProduct({ found, stale }: { found: Intersection3 | null; stale: boolean }) {
  if (!found || found.shifts.length === 0) return null;
  const ways = waysOf(found);
  const hidden = found.shifts.length - MOST_DRAWN;
  return (
    <div class={css["meet-product"]} data-stale={stale ? "" : undefined}>
      <div>
        <h2>Shifts, and the ways between them</h2>
        <MeetGraph found={found} />
        {hidden > 0 && <p class={layout["hint"]}>{hidden} more shifts are not drawn.</p>}
      </div>
      <div>
        <p class={layout["hint"]}>
          Write <Formula tex={tex`X_d`} /> for what the first shape shares with the second moved by{" "}
          <Formula>d</Formula>. A piece <Formula>a</Formula> of the first and a piece <Formula>b</Formula> of
          the second share a smaller copy of such a set again, for the shift{" "}
          <Formula tex={tex`d' = M^{-1}(d + b - a)`} />. Knot 0 is the intersection itself; an arrow says
          which pairs of maps, first · second, lead where.
        </p>
        <Table columns={["Knot", "Shift", "Leads to"]}>
          <tbody>
            {found.shifts.slice(0, MOST_ROWS).map((shift, i) => (
              <tr key={`${i}`}>
                <th scope="row">{i}</th>
                <td class="number">{shiftWords(shift)}</td>
                <td>
                  {ways
                    .filter(({ from }) => from === i)
                    .map(({ to, pairs }) => `${to} (${pairs.length})`)
                    .join(", ")}
                </td>
              </tr>
            ))}
          </tbody>
        </Table>
        {found.shifts.length > MOST_ROWS && (
          <p class={layout["hint"]}>
            The first {MOST_ROWS} of {found.shifts.length}. In brackets: how many pairs of maps.
          </p>
        )}
      </div>
    </div>
  );
}
