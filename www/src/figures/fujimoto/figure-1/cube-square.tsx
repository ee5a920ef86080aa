import type { Point } from "../../kit/maps/pieces";
import { allCodes, cellOf, codeOf, codeWords, lettersOf } from "../codes/codes";
import { pickedClass, picking } from "../codes/picking";
import cubeCss from "./cube.module.css";
import type { CubePartProps } from "./cube-line";

const SIDE = 400;
const GLYPH = 8.5;
/** Lines that are closer than this are left out. */
const CLOSEST = 3;

/** The unit square with its cells: the finest that can be read have their codes, the point's are filled. */
export function CubeSquare({
  cube,
  letters,
  point,
  label,
  onPick,
}: CubePartProps & { onPick?: (at: Point) => void }) {
  const depths = Array.from({ length: letters }, (_, i) => i + 1);
  const [x, y] = [(point[0] ?? 0) * SIDE, (1 - (point[1] ?? 0)) * SIDE];
  const named = depths.filter((depth) => SIDE / cube.parts ** depth > GLYPH * depth + 4).at(-1) ?? 1;
  const cell = SIDE / cube.parts ** named;
  const size = Math.min(cell / 2.2, (0.8 * cell) / (0.62 * named), 26);
  return (
    <svg
      class={`${cubeCss["cube"]} ${onPick ? pickedClass : ""}`}
      viewBox={`-1 -1 ${SIDE + 2} ${SIDE + 2}`}
      role="img"
      aria-hidden={label === null}
      aria-label={label ?? ""}
      {...(onPick ? picking(onPick) : {})}
    >
      {depths.map((depth) => {
        const { corner, side } = cellOf(cube, codeOf(cube, point, depth));
        const [left = 0, low = 0] = corner;
        return (
          <rect
            key={depth}
            class={cubeCss["cube-here"]}
            x={left * SIDE}
            y={(1 - low - side) * SIDE}
            width={side * SIDE}
            height={side * SIDE}
          />
        );
      })}
      {depths.toReversed().map((depth) => {
        const parts = cube.parts ** depth;
        const step = SIDE / parts;
        if (step < CLOSEST) return null;
        const lines = Array.from({ length: parts + 1 }, (_, i) => {
          const at = (i * step).toFixed(2);
          return `M${at} 0V${SIDE}M0 ${at}H${SIDE}`;
        });
        return (
          <path
            key={depth}
            class={`${cubeCss["cube-lines"]} ${depth === 1 ? cubeCss["first"] : depth > named ? cubeCss["deep"] : ""}`}
            d={lines.join("")}
          />
        );
      })}
      {allCodes(lettersOf(cube), named).map((code) => {
        const { corner, side } = cellOf(cube, code);
        const [left = 0, low = 0] = corner;
        return (
          <text
            key={codeWords(code)}
            class={named < letters ? cubeCss["over"] : ""}
            x={(left + side / 2) * SIDE}
            y={(1 - low - side / 2) * SIDE}
            dy="0.35em"
            text-anchor="middle"
            style={{ fontSize: `${size.toFixed(1)}px` }}
          >
            {codeWords(code)}
          </text>
        );
      })}
      <circle class={cubeCss["cube-dot"]} cx={x} cy={y} r={5} />
    </svg>
  );
}
