import { useMemo } from "preact/hooks";
import type { DigitSystem, GridIntersection } from "#wasm/api";
import { look } from "../../kit/directed/look";
import { StatePicture } from "../../kit/directed/state-picture";
import { Formula } from "../../kit/frame/formula";
import layout from "../../kit/frame/layout.module.css";
import { Table } from "../../kit/frame/table";
import { tex } from "../../kit/notation/tex";
import { MOST_DRAWN } from "../graph/layout";
import { StateGraph } from "../graph/state-graph";
import css from "./page.module.css";
import { shiftWords } from "./shift";
import { copiesOf, graphWords, waysOf } from "./words";

interface KindsProps {
  found: GridIntersection;
  first: DigitSystem;
  isLine: boolean;
  stale: boolean;
}

/** Rows of the table, pictures, and shifts and digits that are listed of a kind. */
const MOST_ROWS = 12;
const MOST_PICTURES = 12;
const MOST_LISTED = 3;
/** Digits are told where they are so few. */
const FEW_DIGITS = 4;

/** The kinds of pieces that two shapes share: as a graph, as a table, and each by itself. */
export function Kinds({ found, first, isLine, stale }: KindsProps) {
  const { states, denominator } = found;
  if (states.length === 0) return null;
  const copies = copiesOf(found);
  const digit = (k: number) => {
    const [x, y] = first.digits[k] ?? [0, 0];
    return isLine ? String(x) : `(${x}, ${y})`;
  };
  const holds = (kind: number) =>
    copies
      .filter(({ from }) => from === kind)
      .map(({ to, digits }) =>
        first.digits.length <= FEW_DIGITS
          ? `kind ${to} at ${digits.map(digit).join(", ")}`
          : `${digits.length} of kind ${to}`,
      );
  return (
    <div class={css["kinds"]} data-stale={stale ? "" : undefined}>
      <div class={layout["two-columns"]}>
        <div>
          <h2>Kinds of pieces, and what they hold</h2>
          <StateGraph count={states.length} ways={waysOf(found)} words={graphWords(found)} />
          <p class={layout["hint"]}>
            0 is what the two share. At each arrow: how many copies of the kind it leads to.
            {states.length > MOST_DRAWN && ` ${states.length - MOST_DRAWN} more are not drawn.`}
          </p>
        </div>
        <div>
          <p class={layout["hint"]}>
            After a digit <Formula>d</Formula> of the first and <Formula>d′</Formula> of the second, what is
            left of them lies <Formula tex={tex`t' = M t + d' - d`} /> apart. Only a few such shifts go on for
            ever: they, or sets of them, are the kinds.
          </p>
          <Table columns={["Kind", "Second moved by", "Holds"]}>
            <tbody>
              {states.slice(0, MOST_ROWS).map(({ shifts }, kind) => (
                <tr key={`${kind}`}>
                  <th scope="row">{kind}</th>
                  <td>
                    {listed(
                      shifts.map((shift) => shiftWords(shift, denominator, isLine)),
                      " or ",
                    )}
                  </td>
                  <td class={css["holds"]}>{holds(kind).join("; ")}</td>
                </tr>
              ))}
            </tbody>
          </Table>
          {states.length > MOST_ROWS && (
            <p class={layout["hint"]}>
              The first {MOST_ROWS} of {states.length}.
            </p>
          )}
        </div>
      </div>
      {!isLine && <Pictures found={found} />}
    </div>
  );
}

const listed = (words: readonly string[], between: string) =>
  words.length > MOST_LISTED
    ? `${words.slice(0, MOST_LISTED).join(between)} and ${words.length - MOST_LISTED} more`
    : words.join(between);

/** Each kind by itself, where they are few. */
function Pictures({ found: { system, states } }: { found: GridIntersection }) {
  const shown = system !== null && states.length > 1 && states.length <= MOST_PICTURES ? system : null;
  const seen = useMemo(() => (shown ? look(shown) : null), [shown]);
  if (!shown || seen === null || typeof seen === "string") return null;
  return (
    <div class={css["pictures"]}>
      {seen.boxes.map((box, kind) => (
        <figure key={`${kind}`}>
          <StatePicture system={shown} state={kind} box={box} level={0} label={null} />
          <figcaption>Kind {kind}</figcaption>
        </figure>
      ))}
    </div>
  );
}
