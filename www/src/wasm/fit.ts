import wasmUrl from "../../pkg/frond-fit_bg.wasm?url";
import { compiled, once } from "./module";

/**
 * What traces and fits outlines and finds the maps of graphs, in a module of its own: the workers of the fit have it.
 */
export type FitModule = typeof import("../../pkg/frond-fit.js");
/** What it is given and gives, as `crate/web/src/fit/types.d.ts` promises it. */
export type {
  Collage,
  CollageOptions,
  FitFigures,
  GraphMap,
  HoughCandidate,
  HoughCluster,
  HoughClusters,
  HoughOptions,
  MeasuredCurve,
  PreparedOutline,
} from "../../pkg/frond-fit.js";

/** Fetches and compiles; the workers are given the module. */
export const compileFit = once(() => compiled(wasmUrl));

/** Starts it on this thread: in a worker, and on the page's own where there are no workers. */
export async function startFit(module: WebAssembly.Module): Promise<FitModule> {
  const bindings = await import("../../pkg/frond-fit.js");
  await bindings.default({ module_or_path: module });
  return bindings;
}
