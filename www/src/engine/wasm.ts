import init, * as bindings from "../../pkg/frond.js";
import wasmUrl from "../../pkg/frond_bg.wasm?url";
import type {
  BarnsleyTest,
  BoundingBox,
  Bounds,
  Colouring,
  Connectedness,
  FrondError,
  Ifs,
  IndexBuffer,
  Locus,
  LocusOptions,
  MapRow,
  MorphOptions,
  Pairing,
  PathCheck,
  PathPlan,
  PointCloud,
  Preset,
  RasterOptions,
  Scene,
} from "./api";

/** Rows of a locus, decided coarse to fine without ever repeating a sample. */
export interface LocusTiles {
  run(r0: number, r1: number, stride: number, first: boolean): { state: Uint8Array; gap: Float32Array };
  free(): void;
}

export type Backend = "webgpu" | "webgl2";

export interface RenderStyle {
  colouring: Colouring;
  /** "#rrggbb" */
  palette: string[];
  exposure?: number;
}

/** Draws one attractor on one canvas. Lengths are device pixels. */
export interface Renderer {
  readonly backend: Backend;
  /** The adapter's own words. */
  readonly description: string;
  resize(width: number, height: number, pixelRatio?: number): void;
  /** Six numbers a map. Throws a `FrondError` when they have no attractor. */
  setIfs(maps: Float64Array, probabilities?: Float64Array): void;
  setView(x: number, y: number, scale: number): void;
  setStyle(style: RenderStyle): void;
  draw(budget: number): { complete: boolean; settled: boolean; points: number };
  /** RGBA of the last picture, row 0 on top. */
  readPixels(): Promise<Uint8Array>;
  forceLoss(): void;
  free(): void;
}

/** The package as the page uses it. Functions throw `FrondError` objects. */
export interface Frond {
  presets(): Preset[];
  defaultScene(): Scene;
  /** The fragment, without '#'. */
  encodeScene(scene: Scene): string;
  /** Never throws: a link that cannot be read gives the default and says why. */
  decodeScene(text: string): { scene: Scene; problem?: FrondError };
  validate(ifs: Ifs): void;
  pair(a: Ifs, b: Ifs): Pairing;
  interpolate(from: Ifs, to: Ifs, options: MorphOptions & { u: number; v: number }): Ifs;
  connectedness(ifs: Ifs, options?: { epsilon?: number; budget?: number }): Connectedness;
  indexBuffer(
    ifs: Ifs,
    options: { size: number; points: number; seed: number; margin?: number; weighted?: boolean },
  ): IndexBuffer;
  barnsleyTest(ifs: Ifs, options: { iterations: number }): BarnsleyTest;
  locus(from: Ifs, to: Ifs, options: LocusOptions): Locus;
  planPath(from: Ifs, to: Ifs, options?: MorphOptions & { epsilon?: number; size?: number }): PathPlan;
  planPathIn(locus: Locus, bounds: Bounds): PathPlan;
  checkPath(
    from: Ifs,
    to: Ifs,
    points: [u: number, v: number][],
    options?: MorphOptions & { epsilon?: number; samples?: number },
  ): PathCheck;
  conjugate(ifs: Ifs, transform: MapRow): Ifs;
  attractor(ifs: Ifs, options: { points: number; seed: number }): PointCloud;
  bounds(ifs: Ifs): BoundingBox;
  rasterize(ifs: Ifs, options: RasterOptions): Uint8ClampedArray;
  polar(map: MapRow): {
    angle: number;
    reflects: boolean;
    stretch: [xx: number, xy: number, yy: number];
    determinant: number;
  };
  LocusTiles: new (from: Ifs, to: Ifs, options: LocusOptions) => LocusTiles;
}

/** The one place where the generated bindings meet the page's types. Usable once `load` or `adopt` has resolved. */
export const frond = bindings as unknown as Frond;

let compiled: Promise<WebAssembly.Module> | null = null;

/** Fetches and compiles once. */
function compile(): Promise<WebAssembly.Module> {
  compiled ??= (async () => {
    const response = await fetch(wasmUrl);
    if (!response.ok) throw new Error(`The program could not be loaded (${response.status} for ${wasmUrl}).`);
    // A static host may send wasm under another type, which the streaming compiler refuses.
    try {
      return await WebAssembly.compileStreaming(response.clone());
    } catch {
      return WebAssembly.compile(await response.arrayBuffer());
    }
  })();
  return compiled;
}

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
