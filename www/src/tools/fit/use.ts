/** A fit becomes a shape like any other. */

import { useCurve as takeCurve } from "#document/fit";
import { notify, wordsOf } from "#document/notice";
import type { Curve } from "#wasm/api";
import { rough } from "#wasm/curve";
import { shapeOf, shownFit } from "./work/fitting";
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

/** Takes the fit into another tool: it becomes A. */
export function use(tool: "morph" | "deform"): void {
  const best = shownFit.peek();
  if (!best) return;
  try {
    const shape = shapeOf(best.curve);
    const taken = shape.preset ? shape : { ...shape, curve: rough.quantised(centred(best.curve)) };
    const now = source.peek();
    const presets = rough.curvePresets();
    // A maple-like leaf goes to the oak-like one, whatever else to the maple.
    const wanted = now.kind === "grown" && now.grown !== "oak" ? "oak" : "maple";
    const partner = presets.find((preset) => preset.id === wanted) ?? presets[0];
    if (!partner) throw new Error("there is no other shape");
    takeCurve(taken, partner, tool);
  } catch (problem) {
    notify({ kind: "error", text: `This fit cannot be taken there: ${wordsOf(problem)}` });
  }
}
