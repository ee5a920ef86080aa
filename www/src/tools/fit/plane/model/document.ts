/** The curve of the document, its maps, and what hands do to it. */
import { batch, computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { changeFit, fitDocument } from "#document/fit";
import { wordsOf } from "#document/notice";
import type { PlaneGraph } from "#wasm/api";
import { rough } from "#wasm/curve";
import * as messages from "../../messages";
import {
  type Factor,
  fromWord,
  norm,
  type Place,
  type PlaneCurve,
  request,
  toWord,
  withPiece,
} from "./curve";
import { EXAMPLES } from "./examples";

/** Where nothing was made yet. */
const FIRST: PlaneCurve = EXAMPLES[0]?.make() ?? { points: [], pieces: [] };

const read = computed(() => {
  const word = fitDocument.value.plane;
  return word === undefined ? FIRST : fromWord(word);
});

export const curve: ReadonlySignal<PlaneCurve> = computed(() => read.value ?? FIRST);

const mapsOf = (of: PlaneCurve): PlaneGraph => {
  const { points, options } = request(of);
  return rough.interpolationCurve(points, options);
};

/** Its maps, or why there are none, which only a damaged document brings. */
const made = computed<PlaneGraph | string>(() => {
  if (!read.value) return messages.numbersThisCurveDamaged;
  try {
    return mapsOf(curve.value);
  } catch (wrong) {
    return wordsOf(wrong);
  }
});

/** Its maps; null where it has none. */
export const maps: ReadonlySignal<PlaneGraph | null> = computed(() => {
  if (!read.value) return mapsOf(FIRST);
  return typeof made.value === "string" ? null : made.value;
});

/** What is wrong with the curve of the document. */
export const damage = computed(() => (typeof made.value === "string" ? made.value : null));

export const chosenPiece = signal(0);
export const chosenPoint = signal(0);

/** What stood in the way of the last change; null once one was made. */
export const problem = signal<string | null>(null);

/** The factor that was refused last, as long as nothing else was done. */
export const refused = signal<{ piece: number; factor: Factor } | null>(null);

// What stood in the way of another curve says nothing of this one.
effect(() => {
  fitDocument.value.plane;
  batch(() => {
    problem.value = null;
    refused.value = null;
  });
});

/** Another curve: one undo step, or part of a gesture. Says whether it is one; if not, the last one stays. */
export function change(to: (now: PlaneCurve) => PlaneCurve, gesture?: string): boolean {
  const before = curve.peek();
  const after = to(before);
  if (after === before) return true;
  try {
    mapsOf(after);
  } catch (wrong) {
    const piece = after.pieces.findIndex(({ factor }) => !(norm(factor) < 1));
    const factor = after.pieces[piece]?.factor;
    batch(() => {
      problem.value = wordsOf(wrong);
      refused.value = factor ? { piece, factor } : null;
    });
    return false;
  }
  batch(() => {
    changeFit(
      (fit) => ({ ...fit, mode: "plane", plane: toWord(after) }),
      gesture === undefined ? {} : { gesture },
    );
    settle(after);
  });
  return true;
}

function settle({ pieces }: PlaneCurve): void {
  problem.value = null;
  refused.value = null;
  chosenPiece.value = Math.min(chosenPiece.peek(), pieces.length - 1);
  chosenPoint.value = Math.min(chosenPoint.peek(), pieces.length);
}

export const setFactor = (piece: number, factor: Factor, gesture: string): boolean =>
  change((now) => withPiece(now, piece, { factor }), gesture);

/** The place of the curve at a t. */
export function placeAt(t: number): Place | null {
  const now = maps.peek();
  if (!now) return null;
  const line = rough.sampleInterpolationCurve(now, { tolerance: 0, most: 4096 });
  for (let i = 0; i + 2 < line.length; i += 3) {
    if ((line[i] ?? 0) >= t) return [line[i + 1] ?? 0, line[i + 2] ?? 0];
  }
  return null;
}
