import init, * as bindings from "../../pkg/frond.js";
import wasmUrl from "../../pkg/frond_bg.wasm?url";
import type {
  Bend,
  BendFacts,
  BoundingBox,
  Colouring,
  Curve,
  CurvePreset,
  FrondError,
  Graph,
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

/** What a polyline of a closed curve is to be like. */
export interface CurveView {
  /** In units of the plane: the curve leaves the polyline by no more, or by as little as `most` points allow. */
  tolerance: number;
  /** Finer than `tolerance` is of use only here: outside the polyline is coarse. */
  window?: [minX: number, minY: number, maxX: number, maxY: number];
  /** What bends it; its tint, spin and continuity do not count. */
  bend?: Bend | null;
  /** The most points. Default 65,536. */
  most?: number;
}

/** What there is to say of a closed curve on its way from one to another. */
export interface CurveMorphFacts {
  knots: number;
  copies: number;
  /** Of boxes. */
  dimension: number;
  /** How often the polyline at a five hundredth of the box crosses itself. */
  crossings: number;
  /** The largest factor by which a copy stretches lengths. */
  ratio: number;
}

/** One closed curve, or two brought to one structure: closed at every s. */
export interface CurveMorphHandle {
  /** x0, y0, x1, y1, ..: closed, the first point is not repeated. Throws where the bend cannot be had. */
  polyline(s: number, view: CurveView): Float64Array<ArrayBuffer>;
  bounds(s: number): [minX: number, minY: number, maxX: number, maxY: number];
  facts(s: number): CurveMorphFacts;
  /** For each point of the polyline that was given last the edge that goes on from there, by the knot it begins at. */
  edges(): Uint32Array;
  /** For each edge what it copies at A, then at B: the first knot and the number of edges of the arc; -1 and 0 where straight. */
  arcs(): Int32Array;
  free(): void;
}

export interface CurveFacts {
  /** 2 a knot and 2 a copied edge. */
  numbers: number;
  knots: number;
  copies: number;
  /** Of the packed curve. */
  bytes: number;
  /** Of boxes between 1/64 and 1/256 of the diagonal. */
  dimension: number;
  /** Of a polyline true to 1/2000 of the diagonal. */
  length: number;
  /** The largest factor by which a copy stretches lengths, 0 where all edges are straight. */
  contractivity: number;
}

/** What makes an edge of a closed curve. */
export interface CurveMap {
  /** Takes the arc to the edge; null: it is straight. */
  map: MapRow | null;
  /** The first knot of the arc and how many edges it has; of a straight edge, the edge itself. */
  arc: [from: number, span: number];
  reversed: boolean;
}

export interface GraphFacts {
  /** Under the metric of Cochran, Hart & Flynn, eq 2. */
  contractivity: number;
  /** Of boxes; null where it cannot be told. */
  dimension: number | null;
  /** Whether it was counted, since no equation gives it. */
  counted: boolean;
  /** Between neighbouring pieces. */
  widestGap: number;
  continuous: boolean;
  /** null where a domain does not begin and end at knots. */
  integral: number | null;
  interval: [t0: number, t1: number];
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
  /** One closed curve, or two brought to one structure. */
  CurveMorph: new (
    a: Curve,
    b?: Curve | null,
  ) => CurveMorphHandle;
  curvePresets(): CurvePreset[];
  /** What a link holds. */
  packCurve(curve: Curve): string;
  unpackCurve(text: string): Curve;
  /** As a link brings it back. */
  quantised(curve: Curve): Curve;
  curveFacts(curve: Curve): CurveFacts;
  /** One for each edge. */
  curveMaps(curve: Curve): CurveMap[];
  /** A file: `size` is its longer side, the tolerance is in the same unit, `fill` is "#rrggbb" or "none". */
  curveSvg(curve: Curve, options?: { size?: number; tolerance?: number; fill?: string }): string;
  /** A file: x,y lines of points at equal steps of the parameter, below a line of names. */
  curveCsv(curve: Curve, options?: { points?: number }): string;
  /**
   * The fractal function through points, each piece a copy of the whole; with `spans`, of what lies between two points; with
   * `domains`, of any part. `c` is the roughness of each piece, below 1.
   */
  interpolation(
    points: [t: number, x: number][],
    options: {
      c: number[];
      reflected?: boolean[];
      spans?: [j: number, k: number][];
      domains?: [alpha: number, beta: number][];
    },
  ): Graph;
  /** t0, x0, t1, x1, .. from left to right; x stays within the tolerance between two, or near to that if `most` says so. */
  sampleGraph(
    graph: Graph,
    options?: { tolerance?: number; window?: [t0: number, t1: number]; most?: number },
  ): Float64Array<ArrayBuffer>;
  graphAt(graph: Graph, t: number): number;
  graphFacts(graph: Graph): GraphFacts;
  /** The same as a RFIF; null where that takes more than `most` pieces. */
  toRecurrent(graph: Graph, most: number): Graph | null;
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
