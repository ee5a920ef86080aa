/** Closed curves: what the morph and the deformation work on in place of two systems, where the document has them. */
import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import type { Box } from "#geometry/boxes";
import type { Curve, CurveShape } from "#wasm/api";
import { curvesReady, loadCurves, rough } from "#wasm/curve";
import * as messages from "../messages";
import { notify, wordsOf } from "../notice";
import { scene } from "../scene";

export type CurveMorph = InstanceType<typeof rough.CurveMorph>;

type Ends = { a: CurveShape; b: CurveShape };

const inDocument = computed(() => scene.value.curves ?? null);

/** Gives ends of which a link holds no knots theirs: what draws curves brings it along. */
export const knotted = signal<((ends: Ends) => Ends) | null>(null);

/** The curves of the document, as they are drawn. */
export const curves: ReadonlySignal<Ends | null> = computed(() => {
  const now = inDocument.value;
  return (now && knotted.value?.(now)) ?? now;
});

/** Whether there are curves in place of systems. */
export const curved: ReadonlySignal<boolean> = computed(() => inDocument.value !== null);

// What draws them is loaded with the first ones.
effect(() => {
  if (!curved.value) return;
  loadCurves().catch((problem) =>
    notify({ kind: "error", text: messages.curvesNotLoaded(wordsOf(problem)) }),
  );
});

/** The moment, where there are curves. */
export const curveTime: ReadonlySignal<number> = computed(() => (curved.value ? scene.value.t : 0));

/** The morph between them; null where there is none, or none can be had. The last one is gone when there is another. */
function morphing(): ReadonlySignal<CurveMorph | null> {
  let held: CurveMorph | null = null;
  return computed(() => {
    const now = curves.value;
    held?.free();
    held = null;
    if (!curvesReady.value) return null;
    try {
      if (now) held = new rough.CurveMorph(now.a.curve, now.a.curve === now.b.curve ? null : now.b.curve);
    } catch {
      // Links are checked when they are read, and fits when they are made.
    }
    return held;
  });
}

/** What is asked for the curve at any moment. */
export const curveMorph: ReadonlySignal<CurveMorph | null> = morphing();

/**
 * What the stage asks, always for the present one: a morph keeps what it made for the moment that it was asked last.
 */
export const stageMorph: ReadonlySignal<CurveMorph | null> = morphing();

/** The box of the curve at a moment. */
export function curveBoxAt(morph: CurveMorph, s: number): Box {
  const [x0, y0, x1, y1] = morph.bounds(s);
  return { x0, y0, x1, y1 };
}

/** The box of one curve. */
export function curveBox(curve: Curve): Box {
  const morph = new rough.CurveMorph(curve, null);
  try {
    return curveBoxAt(morph, 0);
  } finally {
    morph.free();
  }
}
