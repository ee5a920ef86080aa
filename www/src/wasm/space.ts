import wasmUrl from "../../pkg/frond-space_bg.wasm?url";
import { compiled, once } from "./module";

/** How a picture of space looks besides what the document says: what the page decides. */
export interface SpaceLook {
  width: number;
  height: number;
  /** Pixels that are carved for each one shown, each way: 1 or 2. */
  factor: 1 | 2;
  /** "#rrggbb": one a map, repeated. */
  palette: string[];
  /** "#rrggbb": what fog fades into. */
  ground: string;
}

/**
 * Space, in a module of its own: the page has it where the tool is open, and so have its workers. Functions throw
 * `FrondError`.
 */
export type SpaceModule = typeof import("../../pkg/frond-space.js");

/** The objects of one moment, ready to be drawn. `free()` it. */
export type SpacePictureHandle = InstanceType<SpaceModule["SpacePicture"]>;
/** A complete picture in the making. `free()` it. */
export type SpaceCarveHandle = ReturnType<SpacePictureHandle["carve"]>;
/** A surface around objects. `free()` it. */
export type SpaceMeshHandle = ReturnType<InstanceType<SpaceModule["SpaceMesher"]>["finish"]>;
/** A `Space` at any moment. `free()` it. */
export type SpaceMotionHandle = InstanceType<SpaceModule["SpaceMotion"]>;

/** Fetches and compiles; the page and its workers are given the module. */
export const compileSpace = once(() => compiled(wasmUrl));

/** What computes space on this thread. Usable once `loadSpace` has resolved. */
export const solid = {} as SpaceModule;

/** Starts it on this thread. */
export const loadSpace = once(async (): Promise<void> => {
  await startSpace(await compileSpace());
});

export async function startSpace(module: WebAssembly.Module): Promise<void> {
  const bindings = await import("../../pkg/frond-space.js");
  await bindings.default({ module_or_path: module });
  Object.assign(solid, bindings);
}
