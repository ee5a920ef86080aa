/** A fit becomes a shape like any other. */
import { effect, signal, untracked } from "@preact/signals";
import { useCurve as takeCurve, type Use } from "#document/fit";
import { notify, wordsOf } from "#document/notice";
import type { Curve, CurveShape } from "#wasm/api";
import { rough } from "#wasm/curve";
import { problem, running, shapeOf, shownFigures, shownFit } from "./work/fitting";
import { prepared } from "./work/outline";
import { source } from "./work/source";

/** The same curve about the origin, its longer side 2: as the shapes of the gallery lie. */
export function centred({ knots, edges }: Curve): Curve {
  const xs = knots.map(([x]) => x);
  const ys = knots.map(([, y]) => y);
  const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const scale = 2 / Math.max(x1 - x0, y1 - y0, 1e-12);
  const [x, y] = [(x0 + x1) / 2, (y0 + y1) / 2];
  return { knots: knots.map(([a, b]) => [(a - x) * scale, (b - y) * scale]), edges };
}

/** Where the fit goes as soon as it is done. */
export const waiting = signal<Use | null>(null);

/** Takes the fit into another tool. One that still improves goes there when it is done. */
export function use(to: Use): void {
  if (running.peek()) waiting.value = waiting.peek() === to ? null : to;
  else take(to);
}

/** Takes along what was to wait for its end. Returns the end of it. */
export function watchUse(): () => void {
  let outline = prepared.peek();
  const stop = effect(() => {
    const to = waiting.value;
    const of = prepared.value;
    // Of another outline nobody has said so.
    if (of !== outline || problem.value !== null) waiting.value = null;
    else if (to !== null && !running.value && shownFigures.value) {
      waiting.value = null;
      untracked(() => take(to));
    }
    outline = of;
  });
  return () => {
    stop();
    waiting.value = null;
  };
}

function take(to: Use): void {
  const best = shownFit.peek();
  const now = source.peek();
  if (best) takeShape(shapeOf(best.curve), to, now.kind === "grown" ? now.grown : undefined);
}

/** Takes a curve into another tool; `grown` says what kind of outline it was made for. */
export function takeShape(shape: CurveShape, to: Use, grown: string | undefined = shape.preset): void {
  try {
    const taken = shape.preset ? shape : { ...shape, curve: rough.quantised(centred(shape.curve)) };
    const presets = rough.curvePresets();
    // A maple-like leaf goes to the oak-like one, whatever else to the maple.
    const wanted = grown !== undefined && grown !== "oak" ? "oak" : "maple";
    const partner = presets.find((preset) => preset.id === wanted) ?? presets[0];
    if (!partner) throw new Error("there is no other shape");
    takeCurve(taken, partner, to);
  } catch (problem) {
    notify({ kind: "error", text: `This fit cannot be taken there: ${wordsOf(problem)}` });
  }
}
