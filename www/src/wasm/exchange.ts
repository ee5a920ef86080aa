import wasmUrl from "../../pkg/frond-exchange_bg.wasm?url";
import { compiled, once } from "./module";

/** Maps from the files of other programs and for them, in a module that is fetched when a file is opened or saved. */
export type Exchange = typeof import("../../pkg/frond-exchange.js");

/** Fetches and starts it. */
export const loadExchange = once(async (): Promise<Exchange> => {
  const [bindings, module] = await Promise.all([import("../../pkg/frond-exchange.js"), compiled(wasmUrl)]);
  await bindings.default({ module_or_path: module });
  return bindings;
});
