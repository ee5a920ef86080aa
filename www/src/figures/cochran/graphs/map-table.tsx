import type { ComponentChildren } from "preact";
import { fixed } from "#format/numbers";
import { Table } from "../../kit/frame/table";
import tableCss from "../../kit/frame/table.module.css";
import type { ShearMap } from "./printed-tables";

interface MapTableProps {
  caption: string;
  /** Names of columns before the five numbers and behind them. */
  before?: readonly string[];
  behind?: readonly string[];
  rows: readonly MapRowProps[];
  /** The name of the first column. */
  first?: string;
  digits?: number;
}

interface MapRowProps {
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
    <Table
      caption={caption}
      columns={[first, ...before, ...[..."abcde"].map((name) => <em key={name}>{name}</em>), ...behind]}
      wide={`${caption} (table)`}
    >
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
    </Table>
  );
}
