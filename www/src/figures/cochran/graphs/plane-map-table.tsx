import { fixed } from "#format/numbers";
import type { PlaneGraphPiece } from "#wasm/api";
import { Table } from "../../kit/frame/table";

const NUMBERS = [
  ["a", ""],
  ["b", "x"],
  ["b", "y"],
  ["c", "x"],
  ["c", "xy"],
  ["c", "yx"],
  ["c", "y"],
  ["d", ""],
  ["e", "x"],
  ["e", "y"],
] as const;

interface PlaneMapTableProps {
  caption: string;
  maps: readonly PlaneGraphPiece["map"][];
  /** The one that is spoken of; it is named as chosen. */
  chosen?: number | null;
}

/** Maps of t, x and y by their ten numbers (eq 9). It scrolls sideways where it is wider than the page. */
export function PlaneMapTable({ caption, maps, chosen = null }: PlaneMapTableProps) {
  return (
    <Table
      caption={caption}
      columns={[
        "Map",
        ...NUMBERS.map(([letter, index]) => (
          <span key={`${letter}${index}`}>
            <em>{letter}</em>
            <sub>{index}</sub>
          </span>
        )),
      ]}
      wide={`${caption} (table)`}
    >
      <tbody>
        {maps.map((map, i) => (
          <tr key={i} aria-current={i === chosen ? "true" : undefined}>
            <th scope="row">
              <em>P</em>
              <sub>{i + 1}</sub>
            </th>
            {map.map((value, k) => (
              <td key={NUMBERS[k]?.join("")}>{fixed(value, 3)}</td>
            ))}
          </tr>
        ))}
      </tbody>
    </Table>
  );
}
