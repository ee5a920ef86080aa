import { Drawn } from "../../kit/picture/annotated";
import { boxesOf, GRIDDED } from "./boxes";
import css from "./page.module.css";

const UNIT = { x0: 0, y0: 0, x1: 1, y1: 1 };
const LEVEL = 3;
const SIDE = 1 / 2 ** LEVEL;

export function Thumb() {
  return (
    <Drawn maps={GRIDDED.gasket.maps} box={UNIT} label={null}>
      {(place) =>
        boxesOf(GRIDDED.gasket, LEVEL).map(([column, row]) => {
          const [x, y] = place([column * SIDE, (row + 1) * SIDE]);
          const [right, bottom] = place([(column + 1) * SIDE, row * SIDE]);
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
        })
      }
    </Drawn>
  );
}
