import type { Place } from "../../kit/picture/annotated";
import css from "./page.module.css";

interface CountedProps {
  /** The boxes by their columns and rows, from the lower left. */
  boxes: readonly (readonly [column: number, row: number])[];
  /** How wide each is. */
  side: number;
  place: Place;
}

/** The boxes that hold some of a shape, over its picture. */
export function Counted({ boxes, side, place }: CountedProps) {
  return (
    <>
      {boxes.map(([column, row]) => {
        const [x, y] = place([column * side, (row + 1) * side]);
        const [right, bottom] = place([(column + 1) * side, row * side]);
        return (
          <rect
            key={`${column},${row}`}
            class={css["box"]}
            x={x}
            y={y}
            width={right - x}
            height={bottom - y}
          />
        );
      })}
    </>
  );
}
