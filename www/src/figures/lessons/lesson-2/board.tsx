import { useLayoutEffect, useRef } from "preact/hooks";
import { dark } from "#document/preferences";
import { palette } from "#style/palette";
import { OrbitPath } from "#ui/orbit/OrbitPath";
import type { Point } from "../../kit/maps/pieces";
import { pictured, usePixels } from "../../kit/picture/canvas";
import { useValue } from "../../kit/workers";
import css from "./board.module.css";
import { CORNERS, type Throws } from "./throws";

interface BoardProps {
  game: Throws;
  /** How far it is: a new number paints anew. */
  count: number;
  label: string | null;
  /** Triangles to be hatched: those that stay empty. */
  holes?: readonly Point[][];
  /** Throws towards the corner that is nearest to where the board was pressed. */
  onThrow?: (corner: number) => void;
}

/** Among more marks than this nobody sees the latest throws. */
const FOLLOWED = 400;
const UNITS = { width: 400, height: 360, side: 340, left: 30, bottom: 326 };

const place = ([x, y]: Point): Point => [UNITS.left + x * UNITS.side, UNITS.bottom - y * UNITS.side];

/** The triangle, all points thrown so far, and the latest ways. */
export function Board({ game, count, label, holes = [], onThrow }: BoardProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const pixels = usePixels(canvas);
  const onDark = useValue(dark);
  const colours = palette(onDark ? "dark" : "light");
  // biome-ignore lint/correctness/useExhaustiveDependencies: `count` says that `game`, one object, has moved on
  useLayoutEffect(() => {
    if (canvas.current && pixels) paint(canvas.current, game, pixels, colours);
  }, [game, count, pixels, onDark]);
  const press = (event: PointerEvent) => {
    const svg = event.currentTarget as SVGSVGElement;
    const box = svg.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * UNITS.width;
    const y = ((event.clientY - box.top) / box.height) * UNITS.height;
    const far = CORNERS.map(place).map(([u, v]) => Math.hypot(u - x, v - y));
    onThrow?.(far.indexOf(Math.min(...far)));
  };
  return (
    <div class={css["board"]}>
      <canvas ref={canvas} {...pictured(label)} />
      <svg
        viewBox={`0 0 ${UNITS.width} ${UNITS.height}`}
        class={onThrow ? css["pressed"] : ""}
        aria-hidden="true"
        onPointerDown={onThrow && press}
      >
        <path class={css["throw-frame"]} d={`M${CORNERS.map((p) => place(p).join(" ")).join("L")}Z`} />
        {holes.map((hole) => (
          <path
            key={hole.join()}
            class={css["hole"]}
            d={`M${hole.map((p) => place(p).join(" ")).join("L")}Z`}
          />
        ))}
        {count < FOLLOWED && (
          <OrbitPath
            points={game.points}
            letters={game.corners}
            colours={colours}
            place={place}
            trail={false}
          />
        )}
        {CORNERS.map((corner, i) => (
          <g
            key={corner.join()}
            style={{ color: colours[i] }}
            transform={`translate(${place(corner).join(" ")})`}
          >
            <circle class={css["corner"]} r={13} />
            <text dy="0.35em" text-anchor="middle">
              {i + 1}
            </text>
          </g>
        ))}
      </svg>
    </div>
  );
}

function paint(
  canvas: HTMLCanvasElement,
  game: Throws,
  { width, height }: { width: number; height: number },
  colours: readonly string[],
): void {
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d");
  if (!context) return;
  const unit = width / UNITS.width;
  // Few points are large, so that they are seen; many are small, so that they are told apart.
  const size =
    Math.max(1.2, Math.min(6, 14 / Math.log2(2 + game.count))) * unit * (game.count > 2000 ? 0.7 : 1);
  for (const [i, point] of game.points.entries()) {
    if (i === 0) continue;
    const [x, y] = place(point);
    context.fillStyle = colours[game.corners[i - 1] ?? 0] ?? "";
    context.fillRect(x * unit - size / 2, y * unit - size / 2, size, size);
  }
}
