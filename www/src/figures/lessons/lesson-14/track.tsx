import type { Point } from "../../kit/maps/pieces";
import { pictured } from "../../kit/picture/canvas";
import css from "./track.module.css";

const WIDTH = 400;
const HEIGHT = 300;

interface TrackProps {
  /** A point, and where it goes step by step. */
  points: readonly Point[];
  /** Half of the height that is seen, in units of the plane. */
  reach: number;
  /** Where the middle is, from the left and from the top: 0 to 1. */
  middle?: Point;
  label: string | null;
}

/** The way of a point, step by step, and the middle that the map leaves in place. */
export function Track({ points, reach, middle = [0.5, 0.5], label }: TrackProps) {
  const scale = HEIGHT / 2 / reach;
  // What is far outside is as good as at the edge of what can be drawn.
  const near = (x: number) => Math.min(1e4, Math.max(-1e4, x));
  const place = ([x, y]: Point) =>
    [near(WIDTH * middle[0] + x * scale), near(HEIGHT * middle[1] - y * scale)] as const;
  const placed = points.map(place);
  const [start] = placed;
  const [left, top] = place([0, 0]);
  const isAbove = points[0]?.[0] === 0;
  const isMiddle = start !== undefined && Math.hypot(start[0] - left, start[1] - top) < 14;
  const line = placed.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L");
  return (
    <div class={css["track"]} {...pictured(label)}>
      <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} aria-hidden="true">
        <path class={css["axis"]} d={`M0 ${top}H${WIDTH}M${left} 0V${HEIGHT}`} />
        <circle class={css["middle"]} cx={left} cy={top} r={6} />
        <path class={css["way"]} d={`M${line}`} />
        {placed.slice(1).map(([x, y], i) => (
          <circle key={i} class={css["step"]} cx={x} cy={y} r={4.5} />
        ))}
        {start && (
          <g transform={`translate(${start.join(" ")})`}>
            <circle class={css["track-start"]} r={6} />
            {/* Not in the way of the points, which go to the right from above the middle. */}
            <text
              class={css["name"]}
              x={isAbove ? -10 : 10}
              y={isMiddle ? -26 : -8}
              text-anchor={isAbove ? "end" : "start"}
            >
              start
            </text>
          </g>
        )}
      </svg>
    </div>
  );
}
