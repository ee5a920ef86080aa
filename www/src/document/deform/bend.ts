/** What the document says of bending, how that is changed, and the bend at the present moment. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import type { Bend, Deformation, DeformKey, Scene } from "#wasm/api";
import { curved } from "../curve/curve";
import { aroundStanding } from "../framing";
import { edit, replace, scene } from "../scene";
import { tool } from "../tool";

export { aroundStanding, boxAround } from "../framing";

/** A mesh of four by four at rest, over the unit square. */
export const AT_REST: Deformation = {
  on: true,
  subject: "shape",
  parts: 2,
  columns: 4,
  rows: 4,
  box: [0, 0, 1, 1],
  keys: [{ at: 0, moves: new Array<number>(32).fill(0) }],
  phase: 0,
  seconds: 4,
  loop: true,
  kb: 0,
  ke: 9,
  delta: 0.75,
  spin: "none",
  continuity: "auto",
  superposed: true,
};

/** On a closed curve a digit stands for a quarter of its length, not for half: fewer go as far, and answer less. */
export const ON_CURVES = { ke: 6, delta: 0.4 } as const;

/** What stands for a document that says nothing of bending. */
const none: ReadonlySignal<Deformation> = computed(() => ({
  ...AT_REST,
  ...(curved.value ? ON_CURVES : {}),
  box: aroundStanding.value,
}));

/** What the document says of bending; a mesh at rest around the shape where it says nothing. */
export const deformation: ReadonlySignal<Deformation> = computed(() => scene.value.deform ?? none.value);

/** One undo step, or a part of one (see `edit`). */
export function changeDeformation(
  change: (deformation: Deformation) => Deformation,
  options: { gesture?: string } = {},
): void {
  edit((now) => withDeformation(now, change), options);
}

/** Without an undo step: the moment, while it plays. */
export function replaceDeformation(change: (deformation: Deformation) => Deformation): void {
  replace(withDeformation(scene.peek(), change));
}

function withDeformation(now: Scene, change: (deformation: Deformation) => Deformation): Scene {
  const before = now.deform ?? none.peek();
  const after = change(before);
  return after === before ? now : { ...now, deform: after };
}

/** Whether the time line of the mesh plays. */
export const phasePlaying = signal(false);

/** Why the bend that is asked for cannot be had, in words; the last one is shown meanwhile. */
export const bendProblem = signal<string | null>(null);

/** Whether the plain bend is looked at for a moment: the document stays what it is. */
export const heldPlain = signal(false);

/** What the stage draws the shape with: null where nothing bends it. */
export const bend: ReadonlySignal<Bend | null> = computed(() => {
  const document = scene.value.deform;
  if (!document || !(document.on || tool.value === "deform")) return null;
  // A picture is bent where it is shown: the morph has no place for one.
  if (document.subject === "picture" && tool.value !== "deform") return null;
  const now = bendAt(document, document.phase);
  return heldPlain.value ? { ...now, kb: now.ke } : now;
});

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
