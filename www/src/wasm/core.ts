import init, * as bindings from "../../pkg/frond-first.js";
import wasmUrl from "../../pkg/frond-first_bg.wasm?url";
import type { Colouring } from "./api";
import { compiled, once } from "./module";

/** How a picture is coloured. */
export interface RenderStyle {
  colouring: Colouring;
  /** "#rrggbb" */
  palette: string[];
  exposure?: number;
  /** Whether what is dense is darkened, for a light ground, and not lightened. */
  lightGround?: boolean;
}

/** The module of the first picture. */
export type Frond = typeof bindings;

/**
 * The package as the page's own thread uses it. Usable once `load` or `adopt` has resolved. Functions throw
 * `FrondError`.
 */
export const frond: Frond = bindings;

/** What workers are given as well. */
export const compile = once(() => compiled(wasmUrl));

/** Main thread: compile, start, and return the module, which the workers are given. */
export async function load(): Promise<WebAssembly.Module> {
  const module = await compile();
  await adopt(module);
  return module;
}

/** Workers: start from a module that is already compiled. */
export async function adopt(module: WebAssembly.Module): Promise<void> {
  await init({ module_or_path: module });
}
