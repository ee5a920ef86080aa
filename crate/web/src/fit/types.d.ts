/** How near a fit is to its outline; errors in percent of the diagonal of the outline's box. */
export interface FitFigures {
  /** Root mean square distance from the outline's points to the fit. */
  rms: number;
  /** No point of either is farther from the other. */
  hausdorff: number;
  /** The fit's length over the outline's. */
  lengthRatio: number;
  /** Box dimensions between 1/64 and 1/256 of the diagonal. */
  outlineSlope: number;
  fitSlope: number;
}

/** What is fitted of an outline. Points are x0, y0, x1, y1, .. */
export interface PreparedOutline {
  points: Float64Array<ArrayBuffer>;
  diagonal: number;
  length: number;
  /** How often it crosses itself, 99 at most; null where it is too tangled to tell. */
  crossings: number | null;
}

/** A closed curve as a link brings it back, and how near it is to an outline. */
export interface MeasuredCurve {
  curve: Curve;
  /** A polyline of it. */
  points: Float64Array<ArrayBuffer>;
  figures: FitFigures;
  /** What it takes up in a link, before it is written in letters. */
  bytes: number;
}

/** Another way to spend so many numbers on an outline. */
export interface RivalFit {
  numbers: number;
  points: Float64Array<ArrayBuffer>;
  figures: FitFigures;
}

export interface CollageOptions {
  maps: number;
  /** Feature points of the outline. */
  features: number;
  /** x and y apart from each other (eq 8), or together (eq 9). */
  separable: boolean;
  /** Whether copies end where their ranges do: then there are no gaps. */
  tied: boolean;
  /** Whether any part may be copied (PFIF), or only what begins where a range does (RFIF). */
  partitioned: boolean;
}

/** The fit of Cochran, Hart & Flynn, section 3.2. */
export interface Collage {
  /** All pieces, one after the other, and the point at which each begins. */
  points: Float64Array<ArrayBuffer>;
  starts: Float64Array<ArrayBuffer>;
  /** x0, y0, x1, y1 of the step from each piece to the next. */
  gaps: Float64Array<ArrayBuffer>;
  /** Of the gaps, in percent of the diagonal. */
  widest: number;
  mean: number;
  /** The sum of squares of eq 15. */
  collage: number;
  numbers: number;
  /** Start of the domain in feature points, reversed (0 or 1), the matrix of c's by rows, b, e. */
  maps: number[][];
  figures: FitFigures;
}

/** Something that may be amiss, though there is a result. */
export interface TraceWarning {
  code: string;
  /** A sentence or two that say what to try. */
  message: string;
}

/** A stroke of a brush on a picture. */
export interface MaskStroke {
  /** x0, y0, x1, y1, ..: where the brush went, in pixels, y down; one point is a dab. */
  points: readonly number[];
  /** Half the brush's width in pixels. */
  radius: number;
  /** Whether it is leaf or not. Later strokes go over earlier ones. */
  what: "keep" | "remove";
}

export interface MaskOptions {
  /** -1 to 1: less or more of the picture is taken for the leaf than was found by itself (0). */
  threshold: number;
  /** Whether stalks are taken off. */
  petiole: "keep" | "remove";
  /** They change what they cover. */
  strokes: readonly MaskStroke[];
  /** They change what looks like what they cover as well. */
  hints?: readonly MaskStroke[];
  /** Whether the leaf is what was taken for the ground. */
  invert?: boolean;
}

export interface TracedMask {
  width: number;
  height: number;
  /** 255 inside, 0 outside, row after row from the top. */
  mask: Uint8Array<ArrayBuffer>;
  /** Where the line was drawn, 0 to 255, and in what. */
  threshold: number;
  channel: "alpha" | "light" | "colour" | "saturation" | "greenness" | "green" | "red" | "blue" | "none";
  /** The largest first, 64 at most: of each its area, its box, a pixel of it. */
  components: {
    area: number;
    box: [left: number, top: number, right: number, bottom: number];
    at: [x: number, y: number];
    touchesBorder: boolean;
  }[];
  warnings: TraceWarning[];
}

export interface TracedOutline {
  /** x0, y0, x1, y1, ..: in pixels, y up, counter-clockwise. */
  points: Float64Array<ArrayBuffer>;
  area: number;
  length: number;
  warnings: TraceWarning[];
}

/** A map of a graph: t' = a t + d, x' = b t + c x + e. */
export type GraphMap = [a: number, b: number, c: number, d: number, e: number];

export interface HoughOptions {
  /** Whether mirrored maps are tried, too; it takes twice as long. */
  reflected?: boolean;
  /** Maps with a smaller |a| or |c| are not counted. */
  leastA?: number;
  leastC?: number;
  /** How many (a, b, c) cells the second pass looks at: 200 at most. */
  cells?: number;
  mostB?: number;
}

/** A map that holds on a part of a graph. */
export interface HoughCandidate {
  map: GraphMap;
  domain: [from: number, to: number];
  /** Coarse feature points that it copies well, and how well: root mean square, in heights of the graph. */
  points: number;
  rms: number;
}

export interface HoughCluster {
  hits: number;
  /** The middle of its bin. */
  map: GraphMap;
  /** The same, in the ranges that are counted: -1 to 1. */
  at: GraphMap;
  /** Along the principal components, from the middle. */
  place: GraphMap;
  kind: "map" | "echo" | "clutter";
  /** Of an echo: the maps that it is composed of, the last done first. */
  echo: { cluster: number; inverse: boolean }[];
  candidate: HoughCandidate | null;
}

export interface HoughClusters {
  /** The most hits first. */
  found: HoughCluster[];
  /** The principal components of the clusters, each with its part of the variance; null where there are no clusters. */
  space: { mean: GraphMap; axes: GraphMap[]; shares: GraphMap } | null;
}

/** How far a pass is, 0 to 1, and how often it has voted. */
export interface HoughProgress {
  share: number;
  votes: number;
}

export interface HoughAssembly {
  graph: Graph;
  /** Which candidate each piece is, before it was cut finer; null where it is straight. */
  used: (number | null)[];
  meanSquare: number;
  worst: number;
  /** Within a tolerance: how many numbers it is made of, and how many a polyline takes that is as near. */
  numbers?: number;
  polyline?: number;
}

/**
 * A fit of an outline x0, y0, x1, y1, ..; one of 12 numbers takes about a tenth of a second, one of hundreds some
 * seconds. `model: "closed"` (the default) spends `numbers`, 12 to 2000, on a closed curve. `"collage"` is the fit of
 * Cochran, Hart & Flynn with so many `maps`.
 */
export function fitCurve(
  outline: Float64Array | number[],
  options?: { model?: "closed"; numbers?: number },
): MeasuredCurve;
export function fitCurve(
  outline: Float64Array | number[],
  options: { model: "collage" } & Partial<CollageOptions>,
): Collage;
export function fitCurve(
  outline: Float64Array | number[],
  options?: { model?: "closed" | "collage"; numbers?: number } & Partial<CollageOptions>,
): MeasuredCurve | Collage;
