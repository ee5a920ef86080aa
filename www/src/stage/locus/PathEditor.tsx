import "./path.css";
import type { ComponentChildren } from "preact";
import { endGesture } from "#document/scene";
import type { Uv } from "#geometry/path";
import { Button, IconButton } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { Segmented } from "#ui/controls/Segmented";
import type { Bounds, PathKind } from "#wasm/api";
import * as messages from "../messages";
import css from "./path.module.css";
import { focusHandle, type WayPath } from "./WayPoints";

const KINDS: readonly { value: PathKind; label: string; description: string }[] = [
  { value: "auto", label: messages.auto, description: messages.frondChoosesPathWith },
  { value: "straight", label: messages.straight, description: messages.turnStretchAndMove },
  { value: "drawn", label: messages.drawn, description: messages.throughYourOwnWaypoints },
];

interface PathSectionProps {
  kind: PathKind;
  onKind: (kind: PathKind) => void;
  children: ComponentChildren;
}

/** What the path is, and what is known of it. */
export function PathSection({ kind, onKind, children }: PathSectionProps) {
  return (
    <section class={css["path"]} aria-labelledby="path-title">
      <header class="section-head">
        <h2 id="path-title">{messages.path}</h2>
        <Segmented label={messages.kindPath} value={kind} options={KINDS} onChange={onKind} />
      </header>
      {children}
    </section>
  );
}

interface WayPointEditorProps {
  path: WayPath;
  bounds: Bounds;
  /** Where else a waypoint may be added. */
  hint: string;
  /** The third number: how far it goes either way, and what asks for it while it is not shown. */
  third?: { shown: boolean; most: number; ask?: ComponentChildren };
}

/** The chosen waypoint by its numbers, or how to have one. */
export function WayPointEditor({ path, bounds, hint, third }: WayPointEditorProps) {
  const index = path.chosen.value;
  const points = path.way.value;
  const full = points.length >= path.most;
  const point = index === null ? undefined : points[index];
  if (index === null || point === undefined) {
    return (
      <div class={css["way-none"]}>
        <Button
          icon="add"
          disabled={full}
          description={messages.addWaypointAtCurrent}
          onClick={() => focusHandle(path.addHere())}
        >
          {messages.addWaypoint}
        </Button>
        <span class="hint">{hint}</span>
      </div>
    );
  }
  const [u, v, w = 0] = point;
  const field = (
    symbol: string,
    label: string,
    value: number,
    range: [number, number],
    to: (x: number) => Uv,
  ) => (
    <NumberField
      terse
      label={label}
      symbol={symbol}
      value={value}
      min={range[0]}
      max={range[1]}
      digits={3}
      onChange={(next) => path.moveTo(index, to(next), `way-${symbol}-${index}`)}
      onDone={endGesture}
    />
  );
  return (
    <fieldset class={`way-point ${third?.shown ? css["with-w"] : ""}`}>
      <legend>
        {messages.waypointOf(index + 1, points.length)} <span class="dim">{path.wayWords(index)}</span>
      </legend>
      {field("u", messages.turnAndStretchU, u, [bounds.u0, bounds.u1], (next) => [next, v, w])}
      {field("v", messages.moveV, v, [bounds.v0, bounds.v1], (next) => [u, next, w])}
      {third?.shown &&
        field("w", messages.stretchLeadW, w, [-third.most, third.most], (next) => [u, v, next])}
      <div class="way-tools">
        {!third?.shown && third?.ask}
        <IconButton
          icon="add"
          label={messages.addWaypointAfterThis}
          kind="quiet"
          disabled={full}
          onClick={() => focusHandle(path.addAfter(index))}
        />
        <IconButton
          icon="bin"
          label={messages.removeThisWaypoint}
          kind="quiet"
          onClick={() => {
            path.removeAt(index);
            focusHandle(null);
          }}
        />
      </div>
    </fieldset>
  );
}
