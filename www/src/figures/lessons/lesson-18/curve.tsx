import { useRef } from "preact/hooks";
import { dark } from "#document/preferences";
import { fixed } from "#format/numbers";
import { palette } from "#style/palette";
import { useValue } from "../../kit/workers";
import css from "./curve.module.css";
import { type Rough, samples } from "./rough";

const [WIDTH, HEIGHT] = [400, 250];
const MARGIN = 20;
/** So many steps are nearly three to a unit of the drawing. */
const STEPS = 1024;
/** What an arrow key moves a point by. */
const STEP = 0.05;

interface CurveProps {
  curve: Rough;
  label: string | null;
  /** Whether it has the width to itself. */
  large?: boolean;
  /** Takes new heights; without it the points stay where they are. */
  onMove?: (heights: number[]) => void;
}

/** A fractal function with the points that it goes through, each piece in a colour of its own. */
export function Curve({ curve, label, large = false, onMove }: CurveProps) {
  const host = useRef<SVGSVGElement>(null);
  const colours = palette(useValue(dark) ? "dark" : "light");
  const heights = samples(curve, Math.round(Math.log(STEPS) / Math.log(curve.factors.length)));
  const [low, high] = [Math.min(0, ...heights), Math.max(1, ...heights)];
  const scale = (HEIGHT - 2 * MARGIN) / (high - low);
  const steps = (heights.length - 1) / curve.factors.length;
  const left = (i: number) => MARGIN + ((WIDTH - 2 * MARGIN) * i) / (heights.length - 1);
  const top = (height: number) => HEIGHT - MARGIN - (height - low) * scale;
  const path = (piece: number) =>
    Array.from(heights.subarray(piece * steps, (piece + 1) * steps + 1), (height, j) =>
      [left(piece * steps + j), top(height)].map((at) => at.toFixed(1)).join(" "),
    ).join("L");
  const move = (i: number, to: number) => {
    const height = Math.round(100 * Math.min(1, Math.max(0, to))) / 100;
    onMove?.(curve.heights.with(i, height));
  };
  const dragTo = (i: number) => (clientY: number) => {
    const box = host.current?.getBoundingClientRect();
    if (!box) return;
    const y = ((clientY - box.top) / box.height) * HEIGHT;
    move(i, low + (HEIGHT - MARGIN - y) / scale);
  };
  const viewBox = `0 0 ${WIDTH} ${HEIGHT}`;
  return (
    <div class={`${css["curve"]} ${large ? css["large"] : ""}`}>
      <svg
        ref={host}
        viewBox={viewBox}
        role="img"
        aria-label={label ?? ""}
        aria-hidden={label === null ? "true" : undefined}
      >
        <path class={css["base"]} d={`M${MARGIN} ${top(0)}H${WIDTH - MARGIN}`} />
        {curve.factors.map((_, piece) => (
          <path key={`${piece + 1}`} class={css["piece"]} stroke={colours[piece]} d={`M${path(piece)}`} />
        ))}
        {curve.heights.map((height, i) => (
          <circle key={`${i + 1}`} class={css["point"]} cx={left(i * steps)} cy={top(height)} r={4} />
        ))}
      </svg>
      {onMove && (
        // biome-ignore lint/a11y/useSemanticElements: a drawing cannot be a fieldset
        <svg class={css["handles"]} viewBox={viewBox} role="group" aria-label="Points to be moved">
          {curve.heights.map((height, i) => (
            <Handle
              key={`${i + 1}`}
              at={[left(i * steps), top(height)]}
              height={height}
              name={`Height of point ${i + 1}`}
              onDrag={dragTo(i)}
              onMove={(to) => move(i, to)}
            />
          ))}
        </svg>
      )}
    </div>
  );
}

interface HandleProps {
  at: [number, number];
  height: number;
  name: string;
  onDrag: (clientY: number) => void;
  onMove: (to: number) => void;
}

/** A point that is dragged up and down, or moved by the arrow keys. */
function Handle({ at: [x, y], height, name, onDrag, onMove }: HandleProps) {
  const onKeyDown = (event: KeyboardEvent) => {
    const to = {
      ArrowUp: height + STEP,
      ArrowRight: height + STEP,
      ArrowDown: height - STEP,
      ArrowLeft: height - STEP,
      Home: 0,
      End: 1,
    }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    onMove(to);
  };
  return (
    <g
      class={css["handle"]}
      transform={`translate(${x.toFixed(1)} ${y.toFixed(1)})`}
      role="slider"
      tabindex={0}
      aria-label={name}
      aria-orientation="vertical"
      aria-valuemin={0}
      aria-valuemax={1}
      aria-valuenow={height}
      aria-valuetext={fixed(height)}
      onKeyDown={onKeyDown}
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
      }}
      onPointerMove={(event) => {
        if (event.currentTarget.hasPointerCapture(event.pointerId)) onDrag(event.clientY);
      }}
    >
      <circle class={css["reach"]} r={24} />
      <circle class={css["point"]} r={7} />
    </g>
  );
}
