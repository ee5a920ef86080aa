/** The mesh of the document at the present moment, and how its moves get into the document. */
import { computed, type ReadonlySignal } from "@preact/signals";
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
