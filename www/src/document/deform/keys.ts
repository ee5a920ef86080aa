/** The key frames of a deformation: which one is meant at a moment, and how it gets its moves. */
import type { Deformation, DeformKey } from "#wasm/api";

export const MOST_KEYS = 32;
/** Keys nearer than this are the same moment. */
export const SAME = 1e-3;

/** The moment as keys count it: 1 is 0 again where it loops. */
export function momentOf({ loop }: Pick<Deformation, "loop">, phase: number): number {
  if (!Number.isFinite(phase)) return 0;
  const within = loop ? phase - Math.floor(phase) : Math.min(1, Math.max(0, phase));
  return loop && within > 1 - SAME ? 0 : within;
}

/** The number of the key at a moment, or -1. One key alone is the mesh at all times. */
export function keyNear({ keys, loop }: Pick<Deformation, "keys" | "loop">, phase: number): number {
  if (keys.length === 1) return 0;
  const at = momentOf({ loop }, phase);
  const apart = (key: DeformKey) => {
    const straight = Math.abs(key.at - at);
    return loop ? Math.min(straight, 1 - straight) : straight;
  };
  let nearest = -1;
  keys.forEach((key, i) => {
    const best = keys[nearest];
    if (apart(key) <= SAME && (!best || apart(key) < apart(best))) nearest = i;
  });
  return nearest;
}

/**
 * The deformation with these moves at this moment: its key gets them, or there is a new one. The same deformation where
 * the moves are no numbers or not one for each control point, and where there is no room for one more key.
 */
export function withMoves(deformation: Deformation, phase: number, moves: readonly number[]): Deformation {
  const { columns, rows, keys } = deformation;
  if (moves.length !== 2 * columns * rows || !moves.every(Number.isFinite)) return deformation;
  const near = keyNear(deformation, phase);
  const before = keys[near];
  if (before) {
    if (before.moves.every((x, i) => x === moves[i])) return deformation;
    const changed = { at: before.at, moves: [...moves] };
    return { ...deformation, keys: keys.map((key, i) => (i === near ? changed : key)) };
  }
  if (keys.length >= MOST_KEYS) return deformation;
  const made = { at: momentOf(deformation, phase), moves: [...moves] };
  return { ...deformation, keys: [...keys, made].sort((p, q) => p.at - q.at) };
}
