/** The mesh of the document at the present moment, and how its moves get into the document. */

import { batch, computed, type ReadonlySignal, signal } from "@preact/signals";
import { changeDeformation, deformation, movesAt } from "#document/deform/bend";
import { keyNear, MOST_KEYS, withMoves } from "#document/deform/keys";
import { notify } from "#document/notice";
import { type Mesh, sizeOf } from "#geometry/mesh";
import { effectiveView } from "#stage/view";
import * as messages from "../messages";

export const mesh: ReadonlySignal<Mesh> = computed(() => {
  const { columns, rows, box, keys, phase, loop } = deformation.value;
  const moves = movesAt(keys, phase, loop);
  return { columns, rows, box, moves: Array.from({ length: 2 * columns * rows }, (_, i) => moves[i] ?? 0) };
});

/** How far a control point may go, in lengths of the longer side of the box: beyond, nothing of the shape is left. */
const FARTHEST_SIDES = 1e4;

/** The longest displacement along one axis. */
export function farthest(box: Mesh["box"]): number {
  return FARTHEST_SIDES * sizeOf(box);
}

/** Gives the control points these moves at the present moment: one undo step, or a part of a gesture. */
export function setMoves(moves: readonly number[], gesture?: string): void {
  const now = deformation.peek();
  if (keyNear(now, now.phase) < 0 && now.keys.length >= MOST_KEYS) {
    notify({
      kind: "info",
      text: messages.mostKeys(MOST_KEYS),
    });
    return;
  }
  const before = mesh.peek().moves;
  const kept = moves.map((x, i) => (x === before[i] ? x : tidy(x, now.box)));
  changeDeformation((d) => withMoves(d, d.phase, kept), gesture === undefined ? {} : { gesture });
}

/** As fine as a hundredth of a pixel, and a ten-thousandth of the box at least, which keeps links short. */
function tidy(x: number, box: Mesh["box"]): number {
  const most = farthest(box);
  const fine = Math.max(100 * effectiveView.peek().scale, 1e4 / sizeOf(box));
  const digits = Math.min(15, Math.max(0, Math.ceil(Math.log10(fine))));
  return Number(Math.min(most, Math.max(-most, x)).toFixed(digits)) + 0;
}

/** Whether the grid lies over the picture: both its lines and its handles. */
export const gridShown = signal(true);

/** What a press beside all handles begins: moving the picture, pulling at the mesh there, or choosing handles. */
export type Hand = "move" | "pull" | "choose";

export const hand = signal<Hand>("move");

// Which handles are chosen, and which one of them the keys act on.

const picked = signal<ReadonlySet<number>>(new Set());
const last = signal(0);

const count = computed(() => mesh.value.columns * mesh.value.rows);

/** Those that a drag of one of them moves. */
export const chosen: ReadonlySignal<ReadonlySet<number>> = computed(() => {
  const all = picked.value;
  // A smaller mesh has lost some of them.
  const kept = [...all].filter((index) => index < count.value);
  return kept.length === all.size ? all : new Set(kept);
});

/** The one that has, or would get, the focus. */
export const lead: ReadonlySignal<number> = computed(() => Math.min(last.value, count.value - 1));

/** Chooses these and no others. */
export function choose(handles: Iterable<number>, leading?: number): void {
  batch(() => {
    picked.value = new Set(handles);
    if (leading !== undefined) last.value = leading;
  });
}

/** Chooses one more, or one less. */
export function toggle(index: number): void {
  const next = new Set(chosen.peek());
  if (!next.delete(index)) next.add(index);
  choose(next, index);
}

export function clearChosen(): void {
  if (picked.peek().size > 0) picked.value = new Set();
}

/** The focus goes to a handle: while no more than one is chosen, the choice goes with it. */
export function lookAt(index: number): void {
  if (chosen.peek().size > 1) last.value = index;
  else choose([index], index);
}
