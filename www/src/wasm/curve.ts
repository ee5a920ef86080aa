import { type ReadonlySignal, signal } from "@preact/signals";
import wasmUrl from "../../pkg/frond-curve_bg.wasm?url";
import { compiled, once } from "./module";

/** Closed curves and graphs, in a module of their own: the page has it where it shows some. */
export type Curves = typeof import("../../pkg/frond-curve.js");

/** One closed curve, or two brought to one structure: closed at every s. `free()` it. */
export type CurveMorphHandle = InstanceType<Curves["CurveMorph"]>;
export type CurveMorphFacts = ReturnType<CurveMorphHandle["facts"]>;
/** What makes an edge of a closed curve. */
export type CurveMap = ReturnType<Curves["curveMaps"]>[number];
/** How a copied edge lies to its arc. */
export type CurveCopy = ReturnType<Curves["curveCopies"]>[number];

const ready = signal(false);

/** Whether `rough` can be used. */
export const curvesReady: ReadonlySignal<boolean> = ready;

/** Whether all that the gallery shows of curves has been fetched ahead, or cannot be had. */
export const curvesFetched = signal(false);

/** What makes rough curves. Usable once `loadCurves` has resolved. */
export const rough = {} as Curves;

/** Fetches and starts it. */
export const loadCurves = once(async (): Promise<void> => {
  const [bindings, module] = await Promise.all([import("../../pkg/frond-curve.js"), compiled(wasmUrl)]);
  await bindings.default({ module_or_path: module });
  Object.assign(rough, bindings);
  ready.value = true;
});
