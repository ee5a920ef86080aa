/** What the document says of bending, how that is changed, and the bend at the present moment. */
import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { bendAt } from "#geometry/bend";
import type { Bend, Deformation, Scene } from "#wasm/api";
import { loadBends } from "#wasm/bend";
import { curved } from "../curve/curve";
import { aroundStanding } from "../framing";
import * as messages from "../messages";
import { notify, wordsOf } from "../notice";
import { edit, replace, scene } from "../scene";
import { tool } from "../tool";

export { bendAt, movesAt } from "#geometry/bend";
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

const bending = computed(() => bend.value !== null);

// What bends is fetched with the first bend.
effect(() => {
  if (!bending.value) return;
  loadBends().catch((problem) => notify({ kind: "error", text: messages.bendsNotLoaded(wordsOf(problem)) }));
});
