import { computed } from "@preact/signals";
import { useRef } from "preact/hooks";
import { endGesture } from "#document/scene";
import { useOwnId } from "#ui/id";
import * as messages from "../messages";
import type { Pixel } from "../stage/camera";
import { part, stageSize } from "../stage/state";
import css from "./bend.module.css";
import { linesOf } from "./bend-edits";
import { bend, changeBend, handles, handleWords, lead, pull, push, take, tell } from "./now";

// What keys do on a handle of the lattice. It is one stop of Tab; within it keys go from handle to handle.

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};
/** Pixels of an arrow key, and the part of the box that a key moves away. */
const STEP = 4;
const PART = 0.01;

const handleId = (index: number): string => `bend-handle-${index}`;

/** True when the key was one of a handle's. */
function handleKey(index: number, event: KeyboardEvent): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const by = event.shiftKey ? 10 : 1;
  const arrow = ARROWS[event.key];
  const gesture = `bend-keys-${index}`;
  if (arrow) {
    pull(index, arrow[0] * STEP * by, arrow[1] * STEP * by, gesture);
    tell(index);
    return true;
  }
  switch (event.key) {
    case "PageUp":
    case "PageDown":
      push(index, (event.key === "PageUp" ? PART : -PART) * by, gesture);
      tell(index);
      return true;
    case "[":
      go(index - 1);
      return true;
    case "]":
      go(index + 1);
      return true;
    case "Delete":
    case "Backspace":
      changeBend((now) => ({ ...now, moves: now.moves.map((old, i) => (i === index ? [0, 0, 0] : old)) }));
      tell(index);
      return true;
    default:
      return false;
  }
}

/** To another handle, round at the ends; those behind the eye are passed over. */
function go(index: number): void {
  const count = bend.peek()?.moves.length ?? 0;
  const step = handles.peek()[(index + count) % count] ? (index + count) % count : null;
  if (step === null) return;
  take(step);
  document.getElementById(handleId(step))?.focus({ preventScroll: true });
}

const HINT = messages.arrowKeysMoveHandle + messages.pageUpAndPage;

const lines = computed(() => {
  const now = bend.value;
  return now ? linesOf(now.sizes) : [];
});

/** The lattice over the picture, while the panel is about it. */
export function BendHandles() {
  const hint = useOwnId("bend-hint");
  const now = bend.value;
  if (part.value !== "bend" || !now) return null;
  const places = handles.value;
  const { width, height } = stageSize.value;
  // The farthest first, so that the nearest lies on top.
  const order = places
    .map((at, index) => ({ at, index }))
    .filter((one): one is { at: Pixel; index: number } => one.at !== null)
    .sort((a, b) => b.at.depth - a.at.depth);
  return (
    <div class={css["bend"]}>
      <svg class={css["bend-lines"]} width={width} height={height} aria-hidden="true">
        {lines.value.map(([from, to]) => {
          const [a, b] = [places[from], places[to]];
          if (!a || !b) return null;
          const ends = { x1: a.x, y1: a.y, x2: b.x, y2: b.y };
          return (
            <g key={`${from} ${to}`}>
              <line class={css["bend-halo"]} {...ends} />
              <line class={css["bend-line"]} {...ends} />
            </g>
          );
        })}
      </svg>
      {/* biome-ignore lint/a11y/useSemanticElements: a fieldset is for forms */}
      <div role="group" aria-label={messages.latticeOf(now.sizes.join(" by "))}>
        <p id={hint} class="unseen">
          {HINT}
        </p>
        {order.map(({ at, index }) => (
          <Handle key={index} index={index} at={at} hint={hint} />
        ))}
      </div>
    </div>
  );
}

let drags = 0;

function Handle({ index, at, hint }: { index: number; at: Pixel; hint: string }) {
  const drag = useRef<{
    x: number;
    y: number;
    gesture: string;
    dx: number;
    dy: number;
    frame: number;
  } | null>(null);
  const leading = lead.value === index;
  const act = () => {
    const now = drag.current;
    if (!now) return;
    now.frame = 0;
    const { dx, dy } = now;
    now.dx = 0;
    now.dy = 0;
    if (dx !== 0 || dy !== 0) pull(index, dx, dy, now.gesture);
  };
  const end = () => {
    const now = drag.current;
    if (!now) return;
    cancelAnimationFrame(now.frame);
    act();
    drag.current = null;
    endGesture();
  };
  return (
    <button
      id={handleId(index)}
      type="button"
      class={css["bend-handle"]}
      style={{ translate: `${at.x.toFixed(1)}px ${at.y.toFixed(1)}px` }}
      tabIndex={leading ? 0 : -1}
      aria-label={handleWords(index)}
      aria-pressed={leading}
      aria-describedby={hint}
      onFocus={() => take(index)}
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.stopPropagation();
        take(index);
        event.currentTarget.setPointerCapture(event.pointerId);
        const { clientX: x, clientY: y } = event;
        drag.current = { x, y, gesture: `bend-drag-${++drags}`, dx: 0, dy: 0, frame: 0 };
      }}
      onPointerMove={(event) => {
        const now = drag.current;
        if (!now) return;
        now.dx += event.clientX - now.x;
        now.dy += event.clientY - now.y;
        now.x = event.clientX;
        now.y = event.clientY;
        // There are more events than frames.
        if (!now.frame) now.frame = requestAnimationFrame(act);
      }}
      onPointerUp={end}
      onPointerCancel={end}
      onKeyDown={(event) => {
        if (!handleKey(index, event)) return;
        event.preventDefault();
        event.stopPropagation();
      }}
      onKeyUp={endGesture}
      onBlur={endGesture}
    />
  );
}
