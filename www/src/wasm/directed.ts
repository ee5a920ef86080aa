import wasmUrl from "../../pkg/frond-directed_bg.wasm?url";
import { compiled, once } from "./module";

/** Graph-directed shapes, in a module of their own: the page has it where it shows some, and so has its worker. */
export type DirectedModule = typeof import("../../pkg/frond-directed.js");

/** Fetches and compiles; the page and its worker are given the module. */
export const compileDirected = once(() => compiled(wasmUrl));

/** What computes them on this thread. Usable once `loadDirected` has resolved. */
export const directed = {} as DirectedModule;

/** Starts it on this thread. */
export const loadDirected = once(async (): Promise<void> => {
  await startDirected(await compileDirected());
});

export async function startDirected(module: WebAssembly.Module): Promise<void> {
  const bindings = await import("../../pkg/frond-directed.js");
  await bindings.default({ module_or_path: module });
  Object.assign(directed, bindings);
}
