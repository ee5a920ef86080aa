import wasmUrl from "../../pkg/frond-svg_bg.wasm?url";
import { compiled, once } from "./module";

/** What reads drawings, in a module that a worker of the fit fetches when one is opened. */
export type Drawings = typeof import("../../pkg/frond-svg.js");

/** Fetches and starts it. */
export const loadDrawings = once(async (): Promise<Drawings> => {
  const [bindings, module] = await Promise.all([import("../../pkg/frond-svg.js"), compiled(wasmUrl)]);
  await bindings.default({ module_or_path: module });
  return bindings;
});
