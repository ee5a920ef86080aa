import drawingsUrl from "../../pkg/frond-svg_bg.wasm?url";
import tablesUrl from "../../pkg/frond-text_bg.wasm?url";
import { compiled, once } from "./module";

/** What reads tables and JSON, in a module that a worker of the fit fetches when one is opened. */
export const loadTables = once(async () => {
  const [bindings, module] = await Promise.all([import("../../pkg/frond-text.js"), compiled(tablesUrl)]);
  await bindings.default({ module_or_path: module });
  return bindings;
});

/** What reads drawings, likewise. */
export const loadDrawings = once(async () => {
  const [bindings, module] = await Promise.all([import("../../pkg/frond-svg.js"), compiled(drawingsUrl)]);
  await bindings.default({ module_or_path: module });
  return bindings;
});
