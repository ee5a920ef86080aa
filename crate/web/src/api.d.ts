/** One affine map: x' = a x + b y + e, y' = c x + d y + f, with y pointing up. */
export type MapRow = [a: number, b: number, c: number, d: number, e: number, f: number];

/** An iterated function system: 1 to 64 affine maps of the plane that have an attractor together. */
export interface Ifs {
  maps: MapRow[];
  /** Chance of each map in the chaos game; they are scaled to sum 1. Default: in proportion to |det|. */
  probabilities?: number[];
}

/** Every function of the package throws one of these. Codes are stable, messages say what to do. */
export interface FrondError {
  code: string;
  message: string;
}

/** `touching`: pieces within epsilon, connected as far as this resolution tells. Never call it connected. */
export type Verdict = "connected" | "disconnected" | "touching" | "undecided" | "no-attractor";

export interface Connectedness {
  verdict: Verdict;
  /** Bounds, in plane units, of the widest edge of the least spanning tree between the pieces. */
  gap: { lower: number; upper: number };
  /** Pairs of maps whose attractorlets meet (or come within epsilon of each other). */
  overlaps: [number, number][];
  /** For each map the number (from 0) of the component its attractorlet is in. */
  components: number[];
  /** How many components there are. */
  count: number;
  /** The points of two components that realise the widest gap; absent when there is none. */
  closest?: { from: [number, number]; to: [number, number] };
  /** Diameter bound of the attractor in plane units: epsilon is relative to it. */
  diameter: number;
  /** Pairs of pieces that were looked at. */
  nodes: number;
}

export type Mode = "polar" | "linear";

export interface MorphOptions {
  mode?: Mode;
  /** `correspondence[i]` is the map of `to` that map i of `from` becomes. Default: the same index. */
  correspondence?: number[];
  /** Whole extra turns of each map. Default: the shortest turn, 0. */
  turns?: number[];
}

/** A rectangle of the (u, v) plane. */
export interface Bounds {
  u0: number;
  v0: number;
  u1: number;
  v1: number;
}

export interface LocusOptions extends MorphOptions {
  /** Default [-1, 2] x [-1, 2]. */
  bounds?: Bounds;
  /** Samples across and up, both ends included: 3 k + 1 puts (0,0) and (1,1) on the grid. */
  width: number;
  height: number;
  /** Relative to the diameter of the attractor. Default 1/600. */
  epsilon?: number;
}

/** Row 0 is v0 (the bottom). `state`: 0 connected, 1 touching, 2 disconnected, 3 undecided, 4 no attractor. */
export interface Locus {
  width: number;
  height: number;
  state: Uint8Array;
  /** Widest gap over the diameter of the attractor, 0 where it holds together; NaN where there is none. */
  gap: Float32Array;
}

export interface PathPlan {
  /** From (0,0) to (1,1), both included. */
  points: [u: number, v: number][];
  /** The widest relative gap met along the path, 0 if it holds together all the way at `epsilon`. */
  gap: number;
  /** Whether no sample along the path was broken. */
  holds: boolean;
}

export interface PathCheck {
  /** The widest relative gap met; Infinity where there is no attractor. */
  gap: number;
  holds: boolean;
  /** Broken stretches, as fractions of the length of the path in (u, v). */
  breaks: [t0: number, t1: number][];
}

export interface Preset {
  id: string;
  name: string;
  /** One sentence for the gallery. */
  about: string;
  maps: MapRow[];
}

/** One end of a morph. `preset` is its gallery id when its maps are untouched. */
export interface Shape {
  preset?: string;
  name: string;
  maps: MapRow[];
}

export type PathKind = "auto" | "straight" | "drawn";
export type Colouring = "map" | "address" | "density";

/** The document: what a link holds. */
export interface Scene {
  a: Shape;
  b: Shape;
  mode: Mode;
  path: {
    kind: PathKind;
    /** Way points between (0,0) and (1,1), which are not listed. At most 64. */
    points: [u: number, v: number][];
  };
  /** Where along the path, by length in (u, v): 0 to 1. */
  t: number;
  /** Empty for the default. */
  correspondence: number[];
  /** Empty for the default. */
  turns: number[];
  colouring: Colouring;
  /** Show the elementwise morph beside the polar one. */
  compare: boolean;
  /** Absent: the whole attractor is fitted to the stage. `zoom` is in pixels a unit over those of the fit. */
  view?: { x: number; y: number; zoom: number };
}

/** Both ends brought to the same number of maps by refining or doubling, which leaves the shapes alone. */
export interface Pairing {
  from: MapRow[];
  to: MapRow[];
  /** One sentence for each step taken, empty when the numbers were equal. */
  steps: string[];
}

export interface IndexBuffer {
  connected: boolean;
  overlaps: [number, number][];
  components: number[];
  count: number;
  /** size x size, row 0 on top: 0 empty, else 1 + map. */
  pixels: Uint8Array;
}

export interface BarnsleyTest {
  disconnected: boolean;
  /** Iterations done. */
  iterations: number;
  /** After each iteration: the largest over i of the least distance d_i, and the bound 2 s^(n+1) R. */
  rounds: { distance: number; bound: number }[];
}

export interface PointCloud {
  /** x0, y0, x1, y1, .. */
  positions: Float32Array;
  /** The map of the last step: the attractorlet each point is in. */
  pieces: Uint8Array;
}

export interface RasterOptions {
  width: number;
  height: number;
  /** World point in the middle and pixels a unit. Default: the whole attractor fitted with a small margin. */
  view?: { x: number; y: number; scale: number };
  colouring?: Colouring;
  /** One sRGB colour "#rrggbb" a map, repeated when there are more maps. */
  palette?: string[];
  /** Whether edges are smoothed; either way the same pixels are lit. Default true. */
  smooth?: boolean;
  /** How bright a density is. Default 1. */
  exposure?: number;
}

export interface BoundingBox {
  min: [number, number];
  max: [number, number];
  /** A convex polygon that holds the attractor, counter-clockwise. */
  hull: [number, number][];
  /** Similarity dimension, when all maps are similitudes. */
  dimension?: number;
}
