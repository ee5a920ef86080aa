/** What comes of the present settings, and what is wrong with them. */
import { computed, type ReadonlySignal } from "@preact/signals";
import { curved } from "#document/curve/curve";
import { aroundStanding, bendProblem, boxAround, deformation } from "#document/deform/bend";
import { pictureMaps } from "#document/deform/picture";
import { standing } from "#document/morph";
import { wordsOf } from "#document/notice";
import { standIn } from "#document/stand-in";
import type { Bend, BendFacts, MapRow } from "#wasm/api";
import { bends } from "#wasm/bend";
import { DEEPEST, roughFrom } from "./deform-edits";

/** The maps that are bent. */
export const maps: ReadonlySignal<MapRow[]> = computed(() =>
  deformation.value.subject === "picture" ? pictureMaps.value : standing.value,
);

/** Whether a closed curve is bent. */
export const ringed: ReadonlySignal<boolean> = computed(
  () => curved.value && deformation.value.subject === "shape",
);

/** Whether the shape is graph-directed, which nothing bends. */
export const unbent: ReadonlySignal<boolean> = computed(
  () => standIn.value === "directed" && deformation.value.subject === "shape",
);

/** Where the mesh belongs. */
export const around: ReadonlySignal<Bend["box"]> = computed(() =>
  deformation.value.subject === "picture" ? boxAround(pictureMaps.value) : aroundStanding.value,
);

/** All that the facts hang on, as text: the moment and the moves are not part of it. */
const settings = computed(() => {
  const { columns, rows, box, kb, ke, delta, spin, continuity, superposed } = deformation.value;
  return JSON.stringify({ columns, rows, box, kb, ke, delta, spin, continuity, superposed });
});

type Answer = { facts: BendFacts | null; problem: string | null };

const answer: ReadonlySignal<Answer> = computed(() => {
  // What there is to say of a curve is said where it is drawn.
  if (ringed.value) return { facts: null, problem: null };
  const plain = JSON.parse(settings.value) as Omit<Bend, "moves">;
  const bend: Bend = { ...plain, moves: new Array<number>(2 * plain.columns * plain.rows).fill(0) };
  try {
    return { facts: bends().bendFacts({ maps: maps.value }, bend), problem: null };
  } catch (problem) {
    return { facts: null, problem: wordsOf(problem) };
  }
});

/** Null where there is no bend to be had. */
export const facts: ReadonlySignal<BendFacts | null> = computed(() => answer.value.facts);

/** Why what is asked for cannot be had; the last good bend is shown meanwhile. */
export const problem: ReadonlySignal<string | null> = computed(
  () => bendProblem.value ?? answer.value.problem,
);

/** Digits to the base of 4 that the place on a curve is taken to, at most. */
const CURVE_DEEPEST = 9;
/** Each digit stands for a quarter of the length. */
const CURVE_ROUGH = 0.25;

/** Sliders go no further, however much memory there is: beyond, nothing is seen. */
const MOST_DETAIL = 24;

/** The largest detail to choose. */
export const deepest: ReadonlySignal<number> = computed(() => {
  const most = facts.value?.deepest ?? (ringed.value ? CURVE_DEEPEST : DEEPEST);
  return Math.max(1, Math.min(MOST_DETAIL, most), Math.min(MOST_DETAIL, deformation.value.ke));
});

export const rough: ReadonlySignal<number> = computed(() =>
  ringed.value ? CURVE_ROUGH : roughFrom(maps.value),
);
