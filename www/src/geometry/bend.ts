/** A bend between its key frames. */
import type { Bend, Deformation, DeformKey } from "#wasm/api";

/** The bend at a moment. */
export function bendAt(document: Deformation, phase: number): Bend {
  const { columns, rows, box, kb, ke, delta, spin, continuity, superposed, tint } = document;
  const plain = { columns, rows, box, kb, ke, delta, spin, continuity, superposed };
  const moves = movesAt(document.keys, phase, document.loop);
  return tint ? { ...plain, moves, tint } : { ...plain, moves };
}

/**
 * The mesh between its keys: a cubic through them with slopes of Catmull and Rom, so that it neither stops at a key nor
 * overshoots where two neighbours are equal.
 */
export function movesAt(keys: readonly DeformKey[], phase: number, loop: boolean): number[] {
  const [first] = keys;
  if (!first) return [];
  if (keys.length === 1) return first.moves;
  const after = keys.findIndex((key) => key.at > phase);
  if (!loop && (phase <= first.at || after === -1)) return (after === -1 ? keys.at(-1) : first)?.moves ?? [];
  const next = after === -1 ? keys.length : after;
  const [p0, p1, p2, p3] = [next - 2, next - 1, next, next + 1].map((i) => keyAt(keys, i, loop)) as [
    DeformKey,
    DeformKey,
    DeformKey,
    DeformKey,
  ];
  const span = p2.at - p1.at;
  const s = span > 0 ? (phase - p1.at) / span : 0;
  const [h00, h10, h01, h11] = [
    (1 + 2 * s) * (1 - s) ** 2,
    s * (1 - s) ** 2 * span,
    s * s * (3 - 2 * s),
    s * s * (s - 1) * span,
  ];
  return p1.moves.map((a, i) => {
    const b = p2.moves[i] ?? a;
    return h00 * a + h10 * slope(p0, p1, p2, i) + h01 * b + h11 * slope(p1, p2, p3, i);
  });
}

/** How fast number i moves at the middle key; 0 where it turns back there, so that nothing overshoots. */
function slope(before: DeformKey, key: DeformKey, after: DeformKey, i: number): number {
  const span = after.at - before.at;
  const [a, b, c] = [before.moves[i] ?? 0, key.moves[i] ?? 0, after.moves[i] ?? 0];
  return span > 0 && (b - a) * (c - b) > 0 ? (c - a) / span : 0;
}

/** Key i, counted on beyond both ends: round again where it loops, else the end itself. */
function keyAt(keys: readonly DeformKey[], i: number, loop: boolean): DeformKey {
  const turn = Math.floor(i / keys.length);
  const index = loop ? i - turn * keys.length : Math.min(Math.max(i, 0), keys.length - 1);
  const key = keys[index] ?? { at: 0, moves: [] };
  return loop ? { ...key, at: key.at + turn } : key;
}
