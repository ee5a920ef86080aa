/** The document and its history: the one place where it is changed. */
import { batch, computed, type ReadonlySignal, signal } from "@preact/signals";
import type { Scene } from "#wasm/api";
import { close, EMPTY, type History, record, stepBack, stepForward } from "./history";
import { keep } from "./keep";
import * as messages from "./messages";

/** Stands until the wasm module has told its own default: a gasket and its mirror image. */
const BLANK: Scene = {
  a: {
    name: "Gasket",
    maps: [
      [0.5, 0, 0, 0.5, 0, 0],
      [0.5, 0, 0, 0.5, 0.5, 0],
      [0.5, 0, 0, 0.5, 0.25, 0.4330127018922193],
    ],
  },
  b: {
    name: messages.mirroredGasket,
    maps: [
      [0.5, 0, 0, 0.5, 0, 0],
      [0.5, 0, 0, 0.5, 0.5, 0],
      [0.5, 0, 0, 0.5, 0.25, -0.4330127018922193],
    ],
  },
  mode: "polar",
  path: { kind: "straight", points: [] },
  t: 0,
  correspondence: [],
  turns: [],
  colouring: "map",
  compare: false,
};

const present = signal<Scene>(BLANK);
const history = signal<History>(EMPTY);
const dragging = signal(false);

/** The document that the page shows: what a link holds. */
export const scene: ReadonlySignal<Scene> = present;
export const canUndo: ReadonlySignal<boolean> = computed(() => history.value.past.length > 0);
export const canRedo: ReadonlySignal<boolean> = computed(() => history.value.future.length > 0);
/** True from the first edit of a gesture to its end. */
export const inGesture: ReadonlySignal<boolean> = dragging;

/**
 * One undo step. Consecutive edits with the same gesture id are one step, until `endGesture`.
 * A change that returns the scene it was given does nothing.
 */
export function edit(change: (scene: Scene) => Scene, options: { gesture?: string } = {}): void {
  const before = present.peek();
  const after = change(before);
  if (after === before) return;
  set(record(history.peek(), before, after, options.gesture), after, options.gesture !== undefined);
}

/** All at once: nobody sees the change without knowing whether it is part of a drag. */
function set(past: History, now: Scene, gesture: boolean): void {
  batch(() => {
    history.value = past;
    present.value = now;
    dragging.value = gesture;
  });
}

/** The pointer was lifted, or the key released: the next edit is a step of its own. */
export function endGesture(): void {
  history.value = close(history.peek());
  dragging.value = false;
}

/** A gesture is given up: what it has changed is as it was, and no step. */
export function takeBack(): void {
  const { past, open } = history.peek();
  const last = open && past.at(-1);
  if (!last) return;
  const back = { past: past.slice(0, -1), future: [], open: false };
  set(back, keep(last.before, last.after, present.peek()), false);
}

/** Changes the scene without an undo step: the playback position, the view, a path planned for the present pair. */
export function replace(next: Scene): void {
  present.value = next;
}

/** What undo would take back: the same one for as long as nothing else was done. */
export const lastStep = (): object | undefined => history.peek().past.at(-1);

/** The last step, if it is not `since`, left another tool: undo goes back there, and redo here. */
export function cameFrom(tool: NonNullable<Scene["tool"]>, since: object | undefined): void {
  const { past, ...rest } = history.peek();
  const last = past.at(-1);
  if (!last || last === since) return;
  history.value = { ...rest, past: [...past.slice(0, -1), { ...last, before: { ...last.before, tool } }] };
}

export function undo(): void {
  move(stepBack(history.peek(), present.peek(), keep));
}

export function redo(): void {
  move(stepForward(history.peek(), present.peek(), keep));
}

function move(to: { history: History; scene: Scene } | null): void {
  if (to) set(to.history, to.scene, false);
}

/** Starts over with another document and no past. */
export function start(first: Scene): void {
  set(EMPTY, first, false);
}
