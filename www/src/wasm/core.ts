import init, * as bindings from "../../pkg/frond.js";
import wasmUrl from "../../pkg/frond_bg.wasm?url";
import type {
  Bend,
  BendFacts,
  BoundingBox,
  Colouring,
  FrondError,
  Ifs,
  MapRow,
  MorphOptions,
  Pairing,
  PointCloud,
  PolygonFamily,
  Preset,
  RasterOptions,
  Scene,
} from "./api";
import { compiled, once } from "./module";

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
  /** What bends it, or null. Throws a `FrondError` when it cannot; the last one stays. Moving the mesh alone is cheap. */
  setBend(bend: Bend | null): void;
  /**
   * A picture (RGBA, straight alpha, row 0 on top) in place of the attractor, on [0, width / height] x [0, 1]; null goes
   * back. The maps must be the parts of that rectangle for a bend to fit it.
   */
  setPicture(rgba: Uint8Array | Uint8ClampedArray | null, width: number, height: number): void;
  draw(budget: number): { complete: boolean; settled: boolean; points: number };
  /** RGBA of the last picture, row 0 on top. */
  readPixels(): Promise<Uint8Array>;
  forceLoss(): void;
  free(): void;
}

/** A picture on the rectangle [0, width / height] x [0, 1], bent without a graphics card. */
export interface SheetHandle {
  /** `parts` x `parts` maps, 2 or 3. Throws a `FrondError` where the bend cannot be had. */
  draw(
    bend: Bend | null,
    parts: number,
    options: {
      width: number;
      height: number;
      view?: { x: number; y: number; scale: number };
      smooth?: boolean;
    },
  ): Uint8ClampedArray<ArrayBuffer>;
  free(): void;
}

/** The package as the page's own thread uses it: what describes and draws. Functions throw `FrondError` objects. */
export interface Frond {
  presets(): Preset[];
  defaultScene(): Scene;
  /** The fragment, without '#'. */
  encodeScene(scene: Scene): string;
  /** Never throws: a link that cannot be read gives the default and says why. */
  decodeScene(text: string): { scene: Scene; problem?: FrondError };
  validate(ifs: Ifs): void;
  pair(a: Ifs, b: Ifs): Pairing;
  interpolate(from: Ifs, to: Ifs, options: MorphOptions & { u: number; v: number; w?: number }): Ifs;
  /** The system of a polygon family at s. */
  familyMaps(family: PolygonFamily, s: [re: number, im: number]): Ifs;
  /** The least real s > 0 at which a polygon family is in one piece: a theorem. */
  criticalScale(sides: number): number;
  conjugate(ifs: Ifs, transform: MapRow): Ifs;
  attractor(ifs: Ifs, options: { points: number; seed: number }): PointCloud;
  bounds(ifs: Ifs): BoundingBox;
  rasterize(ifs: Ifs, options: RasterOptions): Uint8ClampedArray;
  /** What comes of a bend on a shape. Throws where it cannot be had. */
  bendFacts(ifs: Ifs, bend: Bend): BendFacts;
  /** Where count x count points of the mesh go, x0, y0, x1, y1, .. row by row from the lower left: the display grid. */
  meshGrid(bend: Bend, count: number): Float64Array;
  /** Where points of the shape go: codes (letters from 0, at least ke of them) and the points their maps take there. */
  deform(ifs: Ifs, bend: Bend, codes: number[][], tails: [number, number][]): Float64Array;
  /** D_e-uni: reverses the letters kb + 1 to ke (Fujimoto et al., eq 4). */
  shuffle(symbols: number, kb: number, ke: number, code: number[]): number[];
  Sheet: new (rgba: Uint8Array | Uint8ClampedArray, width: number, height: number) => SheetHandle;
  polar(map: MapRow): {
    angle: number;
    reflects: boolean;
    stretch: [xx: number, xy: number, yy: number];
    determinant: number;
  };
}

/** The one place where the generated bindings meet the page's types. Usable once `load` or `adopt` has resolved. */
export const frond = bindings as unknown as Frond;

const compile = once(() => compiled(wasmUrl));

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
