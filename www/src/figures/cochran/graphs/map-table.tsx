import type { ComponentChildren } from "preact";
import { fixed } from "#format/numbers";
import tableCss from "../../kit/frame/table.module.css";
import type { ShearMap } from "./printed-tables";

export interface MapTableProps {
  caption: string;
  /** Names of columns before the five numbers and behind them. */
  before?: readonly string[];
  behind?: readonly string[];
  rows: readonly MapRowProps[];
  /** The name of the first column. */
  first?: string;
  digits?: number;
}

export interface MapRowProps {
  name: ComponentChildren;
  key?: string;
  map: ShearMap;
  before?: readonly ComponentChildren[];
  behind?: readonly ComponentChildren[];
  /** Said quietly: it is not what is looked for. */
  quiet?: boolean;
}

/** Maps by their five numbers. It scrolls sideways where it is wider than the page. */
export function MapTable({
  caption,
  before = [],
  behind = [],
  rows,
  first = "Map",
  digits = 3,
}: MapTableProps) {
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reached by keys
    <section class={tableCss["wide-table"]} aria-label={`${caption} (table)`} tabIndex={0}>
      <table class={tableCss["measurements"]} data-testid="wide-table">
        <caption>{caption}</caption>
        <thead>
          <tr>
            <th scope="col">{first}</th>
            {before.map((name) => (
              <th key={name} scope="col">
                {name}
              </th>
            ))}
            {["a", "b", "c", "d", "e"].map((name) => (
              <th key={name} scope="col" class="symbol">
                {name}
              </th>
            ))}
            {behind.map((name) => (
              <th key={name} scope="col">
                {name}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map(({ name, key, map, before: head = [], behind: tail = [], quiet = false }, i) => (
            <tr key={key ?? i} class={quiet ? tableCss["quiet"] : ""}>
              <th scope="row">{name}</th>
              {head.map((cell, k) => (
                <td key={before[k]}>{cell}</td>
              ))}
              {map.map((value, k) => (
                <td key={"abcde"[k]}>{fixed(value, digits)}</td>
              ))}
              {tail.map((cell, k) => (
                <td key={behind[k]}>{cell}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}
