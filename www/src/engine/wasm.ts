import init, * as bindings from "../../pkg/frond.js";
import wasmUrl from "../../pkg/frond_bg.wasm?url";
import type {
  BarnsleyTest,
  Bend,
  BendFacts,
  BoundingBox,
  Bounds,
  Candidate,
  Certificate,
  CertificateCheck,
  CertifyOptions,
  Colouring,
  Connectedness,
  FamilyOptions,
  FrondError,
  Ifs,
  IndexBuffer,
  Locus,
  LocusOptions,
  MapRow,
  MorphOptions,
  Pairing,
  PathCertificate,
  PathCheck,
  PathOptions,
  PathPlan,
  PathPoint,
  PointCloud,
  PolygonFamily,
  Preset,
  RasterOptions,
  RatedCandidate,
  Route,
  Scene,
} from "./api";

/** Parts of a locus, of a morph or of a polygon family. */
export interface LocusTiles {
  /** Rows, decided coarse to fine without ever repeating a sample. */
  run(r0: number, r1: number, stride: number, first: boolean): { state: Uint8Array; gap: Float32Array };
  /** All samples of a rectangle, row by row: whole boxes are decided at once. */
  patch(x0: number, y0: number, x1: number, y1: number): { state: Uint8Array; gap: Float32Array };
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
  interpolate(from: Ifs, to: Ifs, options: MorphOptions & { u: number; v: number; w?: number }): Ifs;
  connectedness(ifs: Ifs, options?: { epsilon?: number; budget?: number }): Connectedness;
  indexBuffer(
    ifs: Ifs,
    options: { size: number; points: number; seed: number; margin?: number; weighted?: boolean },
  ): IndexBuffer;
  barnsleyTest(ifs: Ifs, options: { iterations: number }): BarnsleyTest;
  locus(from: Ifs, to: Ifs, options: LocusOptions): Locus;
  /** A proof of disconnection; null where there is none to be had. */
  certificate(ifs: Ifs, options?: { epsilon?: number; budget?: number }): Certificate | null;
  /** Replays a proof in exact arithmetic. Never throws for a wrong proof: it says what is wrong with it. */
  checkCertificate(certificate: Certificate): CertificateCheck;
  planPath(from: Ifs, to: Ifs, options?: PathOptions): PathPlan;
  planPathIn(locus: Locus, bounds: Bounds): PathPlan;
  checkPath(
    from: Ifs,
    to: Ifs,
    points: readonly PathPoint[],
    options?: MorphOptions & { epsilon?: number; samples?: number },
  ): PathCheck;
  /** What can be proved of a stretch of a path, by covering it with boxes. */
  certifyPath(from: Ifs, to: Ifs, points: readonly PathPoint[], options?: CertifyOptions): PathCertificate;
  /** Ways to match the maps, the plainest first. */
  candidates(from: Ifs, to: Ifs, options?: { limit?: number }): Candidate[];
  /** One of them with its path and a small locus. */
  rateCandidate(
    from: Ifs,
    to: Ifs,
    options: MorphOptions & { size?: number; epsilon?: number },
  ): RatedCandidate;
  /** Ways to bring two shapes to a morph, those with maps that reflect oppositely above all. */
  routes(from: Ifs, to: Ifs): Route[];
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
  LocusTiles: new (from: Ifs, to: Ifs, options: LocusOptions) => LocusTiles;
  FamilyTiles: new (family: PolygonFamily, options: FamilyOptions) => LocusTiles;
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
