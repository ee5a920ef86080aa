import { fixed } from "#format/numbers";
import css from "./map-blocks.module.css";

/** One affine map of space: the three rows of its matrix, then its translation. */
type Numbers = ArrayLike<number>;

interface MapBlocksProps {
  /** What the maps are, for those who hear it. */
  label: string;
  maps: readonly Numbers[];
  digits?: number;
  /** The number of the first map. Default 1. */
  first?: number;
  /** Whether a number is set apart: the map, and its place in the row of twelve. */
  marked?: (map: number, place: number) => boolean;
  /** What a number that is set apart is, in a word or two: "changed". */
  mark?: string;
}

const ROWS = [0, 1, 2] as const;

/** Maps as they are printed: for each the three rows of its matrix, and behind a line its translation. */
export function MapBlocks({ label, maps, digits = 4, first = 1, marked, mark = "marked" }: MapBlocksProps) {
  return (
    <ul class={css["map-blocks"]} aria-label={label} style={{ "--digits": String(digits) }}>
      {maps.map((map, index) => (
        <li key={index + first}>
          <table class={css["map-block"]}>
            <caption>
              <span class="unseen">Map </span>
              <span aria-hidden="true" class="symbol">
                w
              </span>
              <sub>{index + first}</sub>
            </caption>
            <tbody>
              {ROWS.map((row) => (
                <tr key={row}>
                  {[3 * row, 3 * row + 1, 3 * row + 2, 9 + row].map((place) => {
                    const apart = marked?.(index, place) ?? false;
                    return (
                      <td key={place} class={`${place > 8 ? css["shift"] : ""} ${apart ? css["apart"] : ""}`}>
                        {told(map[place] ?? 0, digits)}
                        {apart && <span class="unseen"> ({mark})</span>}
                      </td>
                    );
                  })}
                </tr>
              ))}
            </tbody>
          </table>
        </li>
      ))}
    </ul>
  );
}

/** As many decimals as asked for, so that columns stand still; beyond a million by its power. */
function told(value: number, digits: number): string {
  if (Math.abs(value) < 1e6) return fixed(value, digits);
  return value.toExponential(1).replace("e+", "e").replace("-", "−");
}
