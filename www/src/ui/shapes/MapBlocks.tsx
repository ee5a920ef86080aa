import { fixed } from "#format/numbers";
import { axesOf, linesOf } from "#geometry/maps/row";
import * as messages from "../messages";
import css from "./map-blocks.module.css";

/** One affine map of the plane or of space: the rows of its matrix, then its translation. */
type Numbers = ArrayLike<number>;

interface MapBlocksProps {
  /** What the maps are, for those who hear it. */
  label: string;
  maps: readonly Numbers[];
  digits?: number;
  /** The number of the first map. Default 1. */
  first?: number;
  /** Whether a number is set apart: the map, and its place in its row of numbers. */
  marked?: (map: number, place: number) => boolean;
  /** What a number that is set apart is, in a word or two: "changed". */
  mark?: string;
}

/** Maps as they are printed: for each the rows of its matrix, and behind a line its translation. */
export function MapBlocks({ label, maps, digits = 4, first = 1, marked, mark = "marked" }: MapBlocksProps) {
  return (
    <ul class={css["map-blocks"]} aria-label={label} style={{ "--digits": String(digits) }}>
      {maps.map((map, index) => (
        <li key={index + first}>
          <table class={css["map-block"]}>
            <caption>
              <span class="unseen">{messages.map} </span>
              <span aria-hidden="true" class="symbol">
                w
              </span>
              <sub>{index + first}</sub>
            </caption>
            <tbody>
              {linesOf(axesOf(map)).map((line) => (
                <tr key={line[0]}>
                  {line.map((place, k) => {
                    const apart = marked?.(index, place) ?? false;
                    const shift = k === line.length - 1;
                    return (
                      <td key={place} class={`${shift ? css["shift"] : ""} ${apart ? css["apart"] : ""}`}>
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
