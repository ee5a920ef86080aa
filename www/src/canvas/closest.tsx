import { verdict } from "../engine/results";
import { lengthWords, verdictWords } from "../state/words";
import { toScreen, world } from "./geometry";
import { effectiveView, stageSize } from "./view";

/** Where the widest gap is: the two points that are nearest across it, and how far apart they are. */
export function ClosestPair() {
  const answer = verdict.value;
  const closest = answer?.connectedness.closest;
  if (!answer || answer.stale || !closest || verdictWords(answer.connectedness).tone !== "broken")
    return null;
  const size = stageSize.value;
  const view = effectiveView.value;
  const p = toScreen(world(...closest.from), view, size);
  const q = toScreen(world(...closest.to), view, size);
  const length = Math.hypot(q.x - p.x, q.y - p.y);
  // The ends stand off a little, so that the points themselves stay free.
  const middle = { x: (p.x + q.x) / 2, y: (p.y + q.y) / 2 };
  const label = lengthWords(answer.connectedness.gap.upper);
  return (
    <svg class="overlay quiet" width={size.width} height={size.height} aria-hidden="true">
      <line class="gap-halo" x1={p.x} y1={p.y} x2={q.x} y2={q.y} />
      <line class="gap-line" x1={p.x} y1={p.y} x2={q.x} y2={q.y} />
      <circle class="gap-ring" cx={middle.x} cy={middle.y} r={Math.max(9, length / 2 + 6)} />
      <text class="gap-label" x={middle.x + Math.max(9, length / 2 + 6) + 6} y={middle.y + 4}>
        {label}
      </text>
    </svg>
  );
}
