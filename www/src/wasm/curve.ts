import { type ReadonlySignal, signal } from "@preact/signals";
import wasmUrl from "../../pkg/frond-curve_bg.wasm?url";
import type { Bend, Curve, CurvePreset, Graph, MapRow } from "./api";
import { compiled, once } from "./module";

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

/** Closed curves and graphs, in a module of their own: the page has it where it shows some. */
export interface Curves {
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
}

const ready = signal(false);

/** Whether `rough` can be used. */
export const curvesReady: ReadonlySignal<boolean> = ready;

/** Whether all that the gallery shows of curves has been fetched ahead, or cannot be had. */
export const curvesFetched = signal(false);

/** What makes rough curves. Usable once `loadCurves` has resolved. */
export const rough = {} as Curves;

/** Fetches and starts it. */
export const loadCurves = once(async (): Promise<void> => {
  const [bindings, module] = await Promise.all([import("../../pkg/frond-curve.js"), compiled(wasmUrl)]);
  await bindings.default({ module_or_path: module });
  Object.assign(rough, bindings);
  ready.value = true;
});
