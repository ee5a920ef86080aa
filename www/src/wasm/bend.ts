import wasmUrl from "../../pkg/frond-bend_bg.wasm?url";
import type { Ifs, RasterOptions } from "./api";
import { frond } from "./core";
import { compiled, once } from "./module";

/** What bends, in a module of its own: a thread has it where something is bent. */
export type Bends = typeof import("../../pkg/frond-bend.js");

/** A picture on a rectangle, bent without a graphics card. `free()` it. */
export type SheetHandle = InstanceType<Bends["Sheet"]>;

let here: Bends | null = null;

/** Whether this thread has it. */
export const bendsReady = (): boolean => here !== null;

/** Fetches it, for this thread and for workers: each of them would fetch it anew. */
const compileBends = once(() => compiled(wasmUrl));

/** Fetches and starts it on this thread. */
export const loadBends = once(() => startBends(compileBends()));

export async function startBends(module: Promise<WebAssembly.Module>): Promise<Bends> {
  const [bindings, compiled] = await Promise.all([import("../../pkg/frond-bend.js"), module]);
  await bindings.default({ module_or_path: compiled });
  here = bindings;
  return here;
}

/** For those who come after `loadBends`. */
export function bends(): Bends {
  if (!here) throw new Error("What bends is not loaded on this thread.");
  return here;
}

/** Whether a picture is drawn by what bends: densities are as well, which the first picture does without. */
const needsBends = ({ bend, colouring }: Pick<RasterOptions, "bend" | "colouring">) =>
  bend !== undefined || colouring === "density";

/** What a worker has to be handed for such a picture, if anything. */
export const bendsFor = (options: Pick<RasterOptions, "bend" | "colouring">) =>
  needsBends(options) ? compileBends() : undefined;

/** Draws an attractor; of a bent one, and of a density, this comes after `loadBends`. */
export function rasterize(ifs: Ifs, options: RasterOptions): Uint8ClampedArray {
  if (needsBends(options)) return bends().rasterize(ifs, options);
  const { bend: _, ...unbent } = options;
  return frond.rasterize(ifs, unbent);
}

/** The same, with what this thread was handed for it; what it was not is fetched. */
export async function rasterized(
  ifs: Ifs,
  options: RasterOptions,
  handed?: WebAssembly.Module,
): Promise<Uint8ClampedArray> {
  if (needsBends(options) && !here) await (handed ? startBends(Promise.resolve(handed)) : loadBends());
  return rasterize(ifs, options);
}
