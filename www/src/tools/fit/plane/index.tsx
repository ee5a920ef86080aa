import graphCss from "../graph/graph.module.css";
import * as messages from "../messages";
import { curve } from "./model/document";
import css from "./plane.module.css";
import { look } from "./stage/shown";

/** The third part of the tool: curves of the plane, made by hand. */
export { PlanePanel } from "./PlanePanel";
export { PlaneStage } from "./stage/PlaneStage";

const WIDTH = 500;
const HEIGHT = 100;

/** The two coordinates of the curve as functions of t. */
export function PlaneStrip() {
  return (
    <div class={graphCss["graph-strip"]}>
      <p class="hint">{messages.dragPointsAnywhereTwo}</p>
      <div class={css["coordinates"]}>
        <Coordinate name="x" at={1} />
        <Coordinate name="y" at={2} />
      </div>
    </div>
  );
}

function Coordinate({ name, at }: { name: string; at: 1 | 2 }) {
  const line = look.value;
  let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (let i = at; i < line.length; i += 3) {
    low = Math.min(low, line[i] ?? 0);
    high = Math.max(high, line[i] ?? 0);
  }
  const { points } = curve.value;
  const [from, to] = [points[0]?.[0] ?? 0, points.at(-1)?.[0] ?? 1];
  const left = (t: number) => ((t - from) / (to - from)) * WIDTH;
  const top = (x: number) => HEIGHT * (0.95 - 0.9 * (high > low ? (x - low) / (high - low) : 0.5));
  const steps: string[] = [];
  for (let i = 0; i + 2 < line.length; i += 3) {
    steps.push(`${left(line[i] ?? 0).toFixed(1)} ${top(line[i + at] ?? 0).toFixed(1)}`);
  }
  return (
    <figure>
      <svg
        viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
        preserveAspectRatio="none"
        role="img"
        aria-label={messages.functionOfT(name)}
      >
        {points.slice(1, -1).map(([t], i) => (
          <path key={i} class={css["knot-line"]} d={`M${left(t).toFixed(1)} 0V${HEIGHT}`} />
        ))}
        {steps.length > 1 && <path class={css["coordinate"]} d={`M${steps.join("L")}`} />}
      </svg>
      <figcaption>{messages.overT(name)}</figcaption>
    </figure>
  );
}
