import { useRef } from "preact/hooks";
import { BOUNDS } from "#compute/locus/job";
import { endGesture } from "#document/scene";
import type { Uv } from "#geometry/path";
import { nearestOn, slice } from "#geometry/polyline";
import { Field } from "#stage/locus/Field";
import { LocusProgress } from "#stage/locus/LocusProgress";
import type { LocusStyle } from "#stage/locus/paint";
import { focusHandle } from "#stage/locus/WayPoints";
import { EPSILON } from "#workers/lanes/locus-fill";
import * as messages from "../messages";
import { Current, Way } from "./handles";
import { addAt, goTo, pick, place, way } from "./waypoints";
import { check, locus, locusProblem, morph, pathless, pathPoints } from "./work";

/** How near to the path a press counts as on it, in CSS pixels. */
const LINE_REACH = 9;
const LABEL = messages.locusOverUTo + messages.handlesMovePath;

/** Where the morph holds together, with the path through it. */
export function Square({ style }: { style: LocusStyle }) {
  const square = useRef<HTMLDivElement>(null);
  const field = locus.value;
  const progress = field?.progress ?? 0;
  const problem = locusProblem.value;
  const toUv = ({ clientX, clientY }: MouseEvent): Uv => {
    const box = square.current?.getBoundingClientRect();
    if (!box || box.width === 0) return [0, 0];
    const [x, y] = [(clientX - box.left) / box.width, (clientY - box.top) / box.height];
    return [BOUNDS.u0 + x * (BOUNDS.u1 - BOUNDS.u0), BOUNDS.v1 - y * (BOUNDS.v1 - BOUNDS.v0)];
  };
  /** The place on the path that is pressed, if it is. */
  const onLine = (event: MouseEvent): number | null => {
    const near = nearestOn(pathPoints.peek(), toUv(event));
    const pixel = (BOUNDS.u1 - BOUNDS.u0) / (square.current?.clientWidth || 1);
    return near.distance < LINE_REACH * pixel ? near.t : null;
  };
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: a press does what the handles do by keys
    <div
      class={`locus-square ${morph.value?.path.kind ?? ""}`}
      ref={square}
      onPointerDown={(event) => {
        if (event.button !== 0 || event.target instanceof HTMLButtonElement) return;
        if (event.target instanceof Element && event.target.closest(".handle")) return;
        const t = onLine(event);
        pick(null);
        if (t === null) return;
        goTo(t);
        endGesture();
      }}
      onDblClick={(event) => {
        event.preventDefault();
        focusHandle(addAt(toUv(event)));
      }}
    >
      <div class="locus-plane" role="img" aria-label={LABEL}>
        <Field
          samples={field && { ...field, bounds: BOUNDS, epsilon: EPSILON }}
          frame={BOUNDS}
          style={style}
        />
      </div>
      <PathLines />
      <End letter="A" at={[0, 0]} />
      <End letter="B" at={[1, 1]} />
      <Current toUv={toUv} />
      {way.value.map((_, index) => (
        // A waypoint has no name but its number: so focus stays while it is moved.
        <Way key={index} index={index} toUv={toUv} />
      ))}
      {problem !== null && (
        <p class="locus-problem" role="status">
          {problem}
        </p>
      )}
      {problem === null && <LocusProgress share={progress} />}
    </div>
  );
}

function End({ letter, at }: { letter: string; at: Uv }) {
  const [x, y] = place(at);
  return (
    <span class="locus-end" style={{ left: `${100 * x}%`, top: `${100 * y}%` }} aria-hidden="true">
      {letter}
    </span>
  );
}

function linePath(points: readonly Uv[]): string {
  return points
    .map((point, i) => {
      const at = place(point).map((x) => (100 * x).toFixed(2));
      return `${i === 0 ? "M" : "L"}${at.join(" ")}`;
    })
    .join("");
}

/** The path, and its broken stretches dashed over it. */
function PathLines() {
  const points = pathPoints.value;
  return (
    <svg class="locus-path" viewBox="0 0 100 100" preserveAspectRatio="none" aria-hidden="true">
      <g class={pathless.value ? "off" : ""}>
        <path class="path-casing" d={linePath(points)} />
        <path class="path-core" d={linePath(points)} />
      </g>
      {(check.value?.breaks ?? []).map(([t0, t1]) => {
        const d = linePath(slice(points, t0, t1));
        return (
          <g key={`${t0}-${t1}`}>
            <path class="path-casing broken" d={d} />
            <path class="path-core broken" d={d} />
          </g>
        );
      })}
    </svg>
  );
}
