import "./path.css";
import { useComputed } from "@preact/signals";
import type { PathKind } from "../../../engine/api";
import { locus, pathBreaks, plan } from "../../../engine/results";
import { pathPoints } from "../../../state/morph";
import { edit, endGesture } from "../../../state/scene";
import { Button, IconButton } from "../../../ui/Button";
import { NumberField } from "../../../ui/NumberField";
import { Segmented } from "../../../ui/Segmented";
import { MOST_POINTS } from "../changes";
import { pathKind } from "../parts";
import { pathWords } from "../words";
import { focusHandle } from "./Handles";
import { widestAlong } from "./polyline";
import { addAfter, addHere, bounds, chosen, moveTo, removeAt, stateAt, way } from "./way";

const KINDS: readonly { value: PathKind; label: string; description: string }[] = [
  { value: "auto", label: "Auto", description: "The way with the narrowest gap, found for you" },
  { value: "straight", label: "Straight", description: "Turn, stretch and move together, at one pace" },
  { value: "drawn", label: "Drawn", description: "Through your own way points" },
];

function setKind(kind: PathKind): void {
  edit((before) => {
    if (kind === before.path.kind) return before;
    // The planned points come with the choice, so that undo and a link hold the path that is seen.
    if (kind === "auto") return { ...before, path: { kind, points: plan.peek()?.points.slice(1, -1) ?? [] } };
    if (kind === "straight") return { ...before, path: { kind, points: [] } };
    return { ...before, path: { ...before.path, kind } };
  });
}

/** What the path is, whether it holds, and its way points by numbers. */
export function PathPanel() {
  const widest = useComputed(() => {
    const field = locus.value;
    return field === null ? null : widestAlong(field, pathPoints.value);
  });
  const breaks = pathBreaks.value;
  const index = chosen.value;
  const point = index === null ? undefined : way.value[index];
  return (
    <section class="path" aria-labelledby="path-title">
      <header class="section-head">
        <h2 id="path-title">Path</h2>
        <Segmented label="Kind of path" value={pathKind.value} options={KINDS} onChange={setKind} />
      </header>
      <p class={`path-verdict ${breaks.length > 0 ? "broken" : "whole"}`}>
        <span class="mark" aria-hidden="true" />
        {pathWords(breaks, widest.value, locus.value?.progress ?? 0)}
      </p>
      {index !== null && point !== undefined ? (
        <fieldset class="way-point">
          <legend>
            Way point {index + 1} of {way.value.length} <span class="dim">{stateAt(point)}</span>
          </legend>
          <NumberField
            terse
            label="turn and stretch, u"
            symbol="u"
            value={point[0]}
            min={bounds.value.u0}
            max={bounds.value.u1}
            digits={3}
            onChange={(u) => moveTo(index, [u, point[1]], `way-u-${index}`)}
            onDone={endGesture}
          />
          <NumberField
            terse
            label="move, v"
            symbol="v"
            value={point[1]}
            min={bounds.value.v0}
            max={bounds.value.v1}
            digits={3}
            onChange={(v) => moveTo(index, [point[0], v], `way-v-${index}`)}
            onDone={endGesture}
          />
          <IconButton
            icon="add"
            label="Add a way point after this one"
            kind="quiet"
            disabled={way.value.length >= MOST_POINTS}
            onClick={() => focusHandle(addAfter(index))}
          />
          <IconButton
            icon="bin"
            label="Remove this way point"
            kind="quiet"
            onClick={() => {
              removeAt(index);
              focusHandle(null);
            }}
          />
        </fieldset>
      ) : (
        <div class="way-none">
          <Button
            icon="add"
            disabled={way.value.length >= MOST_POINTS}
            description="Add a way point where the picture is now"
            onClick={() => focusHandle(addHere())}
          >
            Add way point
          </Button>
          <span class="hint">or press twice above</span>
        </div>
      )}
    </section>
  );
}
