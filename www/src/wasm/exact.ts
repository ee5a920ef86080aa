import wasmUrl from "../../pkg/frond-exact_bg.wasm?url";
import { compiled, once } from "./module";

/** Exact numbers, and what is proved of maps that mean them, in a module that is fetched where there are some. */
export type Exact = typeof import("../../pkg/frond-exact.js");

let fetched = false;

/** Whether it is there, or may be had: without a network a browser complains of what it cannot fetch. */
export const exactAtHand = (): boolean => fetched || navigator.onLine;

/** Fetched once for this thread and for workers. */
export const compileExact = once(async () => {
  const module = await compiled(wasmUrl);
  fetched = true;
  return module;
});

/** Starts it on this thread; a worker is handed the module. */
export const loadExact = once(() => startExact(compileExact()));

let started: Promise<Exact> | null = null;

export function startExact(module: WebAssembly.Module | Promise<WebAssembly.Module>): Promise<Exact> {
  started ??= (async () => {
    const bindings = await import("../../pkg/frond-exact.js");
    await bindings.default({ module_or_path: await module });
    return bindings;
  })();
  return started;
}
