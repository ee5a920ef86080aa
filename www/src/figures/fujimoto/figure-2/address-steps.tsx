import { useMemo } from "preact/hooks";
import { dark } from "#document/preferences";
import { palette } from "#style/palette";
import type { Point } from "../../kit/maps/pieces";
import annotatedCss from "../../kit/picture/annotated.module.css";
import { Picture } from "../../kit/picture/picture";
import { useValue } from "../../kit/workers";
import { pieceOf, rightGasket, type Triangle } from "../codes/addresses";
import { allCodes, codeWords } from "../codes/codes";
import { pickedClass, picking } from "../codes/picking";
import css from "./address-steps.module.css";

const SIDE = 400;
const BOX = { x0: 0, y0: 0, x1: 1, y1: 1 };
/** Around the triangle, so that the ring is whole at its corners. */
const MARGIN = 0.06;
const UNIT = SIDE * (1 - 2 * MARGIN);
/** Names are written to this step. */
const NAMED = 3;

interface StepsProps {
  r: number;
  /** How many steps; null for the attractor itself. */
  depth: number | null;
  point: Point;
  /** The pieces that hold the point. */
  here: readonly Triangle[];
  label: string | null;
  onPick?: (at: Point) => void;
}

const place = ([x, y]: Point): Point => [SIDE * MARGIN + x * UNIT, SIDE * (1 - MARGIN) - y * UNIT];
const path = (triangle: Triangle) =>
  `M${triangle
    .map((p) =>
      place(p)
        .map((x) => x.toFixed(1))
        .join(" "),
    )
    .join("L")}Z`;

/** What is left of a triangle after so many steps of three maps, or after all, with a point ringed. */
export function Steps({ r, depth, point, here, label, onPick }: StepsProps) {
  const maps = useMemo(() => rightGasket(r), [r]);
  const colours = palette(useValue(dark) ? "dark" : "light");
  const [x, y] = place(point);
  const pieces = useMemo(
    () => (depth === null ? [] : allCodes(3, depth).map((code) => ({ code, corners: pieceOf(maps, code) }))),
    [maps, depth],
  );
  const pick =
    onPick &&
    picking(([u, v]) => onPick([u, v].map((at) => within((at - MARGIN) / (1 - 2 * MARGIN))) as Point));
  return (
    <div class={`${annotatedCss["drawn"]} ${css["steps"]} ${onPick ? pickedClass : ""}`} {...pick}>
      {depth === null && <Picture maps={maps} box={BOX} label={label} margin={MARGIN} />}
      <svg
        viewBox={`0 0 ${SIDE} ${SIDE}`}
        role="img"
        aria-hidden={depth === null || label === null}
        aria-label={label ?? ""}
      >
        {pieces.map(({ code, corners }) => (
          <path
            key={codeWords(code)}
            class={css["step-piece"]}
            style={{ color: colours[code[0] ?? 0] }}
            d={path(corners)}
          />
        ))}
        {depth !== null &&
          here.map((corners, i) => <path key={`${i + 1}`} class={css["step-here"]} d={path(corners)} />)}
        {depth !== null &&
          depth <= NAMED &&
          pieces.map(({ code, corners }) => {
            // Nearer to the right angle than the middle is: there the triangle is wide.
            const [a, b, c] = corners.map(place) as [Point, Point, Point];
            const at = [0, 1].map((axis) => 0.42 * (a[axis] ?? 0) + 0.29 * ((b[axis] ?? 0) + (c[axis] ?? 0)));
            return (
              <text
                key={codeWords(code)}
                x={at[0]}
                y={at[1]}
                dy="0.35em"
                text-anchor="middle"
                style={{ fontSize: `${[30, 26, 15][depth - 1]}px` }}
              >
                {codeWords(code)}
              </text>
            );
          })}
        <circle class={`${annotatedCss["lens"]} ${annotatedCss["halo"]}`} cx={x} cy={y} r={10} />
        <circle class={annotatedCss["lens"]} cx={x} cy={y} r={10} />
      </svg>
    </div>
  );
}

function within(x: number): number {
  return Math.min(1, Math.max(0, x));
}
