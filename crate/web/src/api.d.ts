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
  /** For each map the number (from 0) of the cluster of attractorlets that its own hangs together with. */
  components: number[];
  /**
   * How many clusters there are. The attractor may well be in more parts: attractorlets may be in pieces themselves.
   */
  count: number;
  /** The points of two components that realise the widest gap; absent when there is none. */
  closest?: { from: [number, number]; to: [number, number] };
  /** Diameter bound of the attractor in plane units: epsilon is relative to it. */
  diameter: number;
  /** Pairs of pieces that were looked at. */
  nodes: number;
  /** Why it is `connected`; or, where it is `touching`, under which reading of its numbers it would be. */
  reason?: Reason;
}

export type ReasonKind =
  | "one-map"
  | "equal-maps"
  | "common-point"
  | "area"
  | "shared-points"
  | "crossings"
  | "line"
  | "differences"
  | "neighbours";

/** A reason that can be shown for an attractor to be in one piece. */
export interface Reason {
  kind: ReasonKind;
  /** The reason in a sentence or two. */
  text: string;
  /** What holds the pieces together: enough of them to reach every piece. Empty where one fact covers all. */
  links: Link[];
  /**
   * Readings of numbers that it hangs on, such as "0.3333333333333333 is 1/3". Empty for a proof about the maps as they
   * are given; otherwise the verdict stays `touching`, since the given numbers only come near.
   */
  assuming: string[];
  /** How many neighbour types there are, where the neighbour graph closed. */
  neighbours?: number;
}

/**
 * What holds two pieces together: a point that both have, two paths that must cross, an overlap on the line that holds
 * the shape, areas too large to leave room, or a step between two copies of one shape that is the difference of two
 * of its points.
 */
export interface Link {
  kind: "point" | "crossing" | "line" | "area" | "difference";
  /** Two maps, the smaller index first. */
  pair: [i: number, j: number];
  /**
   * The addresses of the point, or the words of the pieces, as people read them: letters from 1, "1(2)" is
   * 1222.. Of more than nine maps letters are joined by dots: "12.3.(10)".
   */
  words: [string, string];
  /** The shared point, or the middle of the crossing. */
  at: [x: number, y: number];
  /** Of a crossing: two far points of the first piece, then two of the second. On a line: the ends of both. */
  corners?: [x: number, y: number][];
}

/** A proof that an attractor is in several pieces, which `checkCertificate` replays in exact arithmetic. */
export interface Certificate {
  maps: MapRow[];
  /** A convex polygon, counter-clockwise, that every word of `letters` letters maps into its inside. */
  polygon: [x: number, y: number][];
  letters: number;
  /** For each map the side of the cut it is on. */
  side: (0 | 1)[];
  /** Pieces that are apart, as words (letters from 0), and a direction that shows it. */
  pairs: { u: number[]; v: number[]; normal: [x: number, y: number] }[];
  /** Without it the doubles of `maps` are meant. */
  exact?: ExactEntries;
}

/** A proof that an attractor is in one piece, which `checkCertificate` replays in exact arithmetic. Letters from 0. */
export interface ConnectedCertificate {
  maps: MapRow[];
  /** A convex polygon, counter-clockwise, that every map takes into its inside. */
  polygon: [x: number, y: number][];
  /** No gap is wider, where the polygon is 1 wide in all directions; from 1 on that is always so. */
  gap: number;
  /** Words of pieces so near that no gap is wider. */
  near: [u: number[], v: number[]][];
  /** What holds pieces together. */
  links: CertifiedLink[];
  /** Where all maps have one linear part L: squares full of differences of two points of the attractor. */
  squares?: {
    size: [width: number, height: number];
    /** Column and row from the origin, and two maps: x -> L^-1 (x - (t_k - t_l)) takes the square into squares. */
    cells: [x: number, y: number, k: number, l: number][];
  };
  /** Without it the doubles of `maps` are meant. */
  exact?: ExactEntries;
}

/** Entries of maps that are numbers of one field: powers of a root of a polynomial with fractions before them. */
export interface ExactEntries {
  /** Whole numbers as texts, the constant term first; `["0", "1"]` for fractions. */
  polynomial: string[];
  /** Fractions such as "7/4": the one root between these is meant. */
  root: [low: string, high: string];
  /** `entry` counts `[a, b, c, d, e, f]` from 0. `value`: the fractions before 1, the root, its square and so on. */
  entries: { map: number; entry: number; value: string[] }[];
}

/** A formula, read: the double nearest to its number and its shortest text; or why it is none, in a sentence. */
export type ReadNumber = { value: number; text: string } | { problem: string };

/** What is proved of maps some of whose entries mean numbers that are no doubles. */
export type ExactProof =
  | { state: "connected"; reason: Reason; certificate: ConnectedCertificate }
  | { state: "disconnected"; certificate: Certificate }
  /** Nothing: why, in a sentence. */
  | { state: "undecided"; why: string };

/** A Hausdorff dimension between bounds. */
export interface Dimension {
  value: number;
  lower: number;
  upper: number;
  /** Whether the lower bound is proved as well; the upper one always is. */
  proved: boolean;
  /** The dimension as people write it, such as "log 4 / log 3"; null where it has no such form. */
  exact: string | null;
}

/** What the ways in which pieces touch tell of a shape. */
export interface Analysis {
  /** Whether there are open sets that the maps send into one another without an overlap. */
  openSetCondition: "yes" | "no" | "undecided";
  /** In how many ways pieces of like size lie to each other where they meet; null where not all were found. */
  neighbours: number | null;
  /** An upper bound where a map is no similarity. Null where nothing is known. */
  dimension: Dimension | null;
  /** Null where there are no inner points, or pieces coincide. */
  boundary: {
    dimension: Dimension;
    /** As a graph-directed shape; null where that has too many states or maps. */
    states: DirectedMap[][] | null;
  } | null;
  innerPoints: boolean | null;
  /** Why it is known, or not: the kind of theorem or limit, with its numbers. */
  reasons: { kind: string; count?: number; words?: [number[], number[]] }[];
}

export type CertifiedLink =
  | { kind: "point"; addresses: [RepeatedWord, RepeatedWord] }
  | { kind: "area"; pair: [i: number, j: number] }
  /** All lies on a line: two points of one piece, and one of another that lies between them. */
  | { kind: "between"; addresses: [RepeatedWord, RepeatedWord, RepeatedWord] }
  /** Steps as those of squares lead from L^-1 (t_j - t_i) into them. */
  | { kind: "difference"; pair: [i: number, j: number]; steps: [k: number, l: number][] }
  /** Two pieces, and parts that jut out beyond the other one along a direction: two of the first, two of the second. */
  | {
      kind: "crossing";
      words: [u: number[], v: number[]];
      far: { tail: number[]; direction: [x: number, y: number] }[];
    };

/** An endless word: `head` once, then `repeat` without end. */
export interface RepeatedWord {
  head: number[];
  repeat: number[];
}

export interface CertificateCheck {
  valid: boolean;
  /** What was checked, or what is wrong with it, in a sentence. */
  text: string;
  /** How many pairs of pieces are apart. */
  pairs: number;
  /** How many links hold pieces together. */
  links: number;
  /** Letters of the longest word. */
  longest: number;
}

export type Mode = "polar" | "linear";

/**
 * Which way maps go that turn by half a turn, which is as short either way: by the signs of the angles, as eq 6 of
 * Burch & Hart (1997) has it, or all of them one way. Default: `signs`.
 */
export type HalfTurns = "signs" | "counterclockwise" | "clockwise";

export interface MorphOptions {
  mode?: Mode;
  /** `correspondence[i]` is the map of `to` that map i of `from` becomes. Default: the same index. */
  correspondence?: number[];
  /**
   * Whole extra turns of each map, counter-clockwise; in space about the axis of its turn that points up. Default: the
   * shortest turn, 0; where that is half a turn, the one that the signs of eq 6 give (Burch & Hart 1997). The other one
   * is what `halfTurns` says.
   */
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
  /** The slice: how far the stretch is ahead of the turn. Default 0, the plane of Burch & Hart. */
  w?: number;
}

/** The systems s z + exp(2 pi i k / sides), k = 0 .. sides - 1, over the complex s. Two sides: the set M. */
export interface PolygonFamily {
  /** 2 to 64. */
  sides: number;
}

/** `bounds` are those of s: u its real, v its imaginary part. */
export interface FamilyOptions {
  bounds: Bounds;
  width: number;
  height: number;
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

/**
 * A parameter of a morph: u turns and stretches, v moves; w, 0 where absent, is how far the stretch is ahead of the
 * turn.
 */
export type PathPoint = [u: number, v: number, w?: number];

export interface PathPlan {
  /** From (0,0) to (1,1), both included. */
  points: PathPoint[];
  /** The widest relative gap met along the path, 0 if it holds together all the way at `epsilon`. */
  gap: number;
  /** Whether no sample along the path was broken. */
  holds: boolean;
  /** The least distance, in (u, v, w), from what is broken. */
  clearance: number;
  /** Where the gap is widest; absent if it holds. */
  worst?: PathPoint;
  /**
   * Whether the ends lie in different components of what holds on the samples looked at: then no path within them
   * holds.
   */
  apart?: boolean;
}

export interface PathOptions extends MorphOptions {
  /** Default 1/600. */
  epsilon?: number;
  /** Samples a side of the locus it looks through. */
  size?: number;
  /** 3: also with the stretch ahead of or behind the turn. Default 2. */
  axes?: 2 | 3;
}

export interface CertifyOptions extends MorphOptions {
  /** The relative gap that is to be excluded. Default 1/600. */
  within?: number;
  /**
   * The stretch of the path, by length; one moment where t1 is t0. Default 0 to 1. What is no stretch of it is
   * refused.
   */
  t0?: number;
  t1?: number;
  /** The most boxes to look at; fewer where each takes long. */
  budget?: number;
}

/** What is proved of a stretch of a path. */
export interface PathCertificate {
  /** No relative gap wider than this anywhere on the stretch: proved. Infinity where nothing is. */
  gap: number;
  /** Whether that is no more than was asked for. */
  holds: boolean;
  /** Boxes that cover the stretch. */
  boxes: number;
  /** Where the least could be proved, by length of the whole path. */
  worst: number;
  /**
   * Whether the question is answered: it holds, or a gap as wide is there. Otherwise less could not be proved within
   * the budget.
   */
  complete: boolean;
  /** How many joints of pieces the bound rests on, which stay joined on the whole path; 0 where it rests on boxes. */
  joints: number;
}

/** A way to match the maps of two shapes. */
export interface Candidate {
  correspondence: number[];
  turns: number[];
  /** How far the maps have to move: the smaller, the plainer. */
  cost: number;
}

export interface RatedCandidate extends Candidate {
  plan: PathPlan;
  /** The share of the locus where it holds together. */
  share: number;
  locus: Locus;
}

export type RouteKind =
  | "plain"
  | "collapse"
  | "correspondence"
  | "symmetry"
  | "mirror"
  | "refine"
  | "double"
  | "joints"
  | "place";

/** A way to bring two shapes to a morph. Both keep their shape; only the maps that make it may be others. */
export interface Route {
  kind: RouteKind;
  /** A sentence that says what happens on it. */
  about: string;
  from: MapRow[];
  to: MapRow[];
  /** How probable the maps are: each piece is as often met as it was. */
  fromProbabilities: number[];
  toProbabilities: number[];
  correspondence: number[];
  turns: number[];
  /** How far the maps have to move. */
  cost: number;
  /** How the maps have to be mixed; absent where either will do. */
  mode?: Mode;
  /** Where the last shape was laid: the similarity that takes it there. Absent where it stays. */
  place?: MapRow;
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
  /** How often the chaos game takes each map, as shares, whatever their sum. Absent: in proportion to its area. */
  weights?: number[];
  /**
   * Formulas of numbers, such as "1/3", "sqrt(3)/6" or "2**(1/3)", in lower case, 64 at most. Where an entry of a map
   * is the double nearest to one of them or to its negative, that number is meant, and not the double.
   */
  exact?: string[];
}

export type PathKind = "auto" | "straight" | "drawn";
/** `"grid"`: the colours of a bend's tint; without one it is `"map"`. */
export type Colouring = "map" | "address" | "density" | "grid";

/** The document: what a link holds. */
export interface Scene {
  a: Shape;
  b: Shape;
  mode: Mode;
  path: {
    kind: PathKind;
    /** Waypoints between (0,0) and (1,1), which are not listed. At most 64. */
    points: PathPoint[];
  };
  /** Where along the path, by length in (u, v): 0 to 1. */
  t: number;
  /** Empty for the default. */
  correspondence: number[];
  /** Empty for the default. */
  turns: number[];
  colouring: Colouring;
  /** "#rrggbb": the colours of the maps, repeated where there are more maps; at most 64. Absent: the page's own. */
  palette?: string[];
  /** Show the elementwise morph beside the polar one. */
  compare: boolean;
  /** Absent: the whole attractor is fitted to the stage. `zoom` is in pixels a unit over those of the fit. */
  view?: { x: number; y: number; zoom: number };
  /** How the locus is looked at. Absent: all of the morph's plane, and the picture is where the path is. */
  locus?: LocusView;
  /** The tool that is open. Absent: the morph. */
  tool?: Tool;
  /** What bends the shape. Absent: nothing does. */
  deform?: Deformation;
  /** Present: the morph and the deformation work on these closed curves, in place of `a` and `b`. */
  curves?: { a: CurveShape; b: CurveShape };
  /** Present, and no curves: the morph works on these graph-directed shapes, in place of `a` and `b`. */
  directed?: { a: DirectedShape; b: DirectedShape; halfTurns?: HalfTurns };
  /** How an outline or a graph was fitted last. */
  fit?: Fit;
  /** What there is in space. Absent: what the tool begins with. */
  space?: SpacePart;
}

export type Tool = "morph" | "deform" | "fit" | "space";

/** What an edge of a closed curve copies: the arc over `span` edges, 2 or more, from knot `from` on. */
export interface CurveEdge {
  from: number;
  span: number;
  /** Whether the arc's end comes to lie where the edge begins. */
  reversed: boolean;
  /** The roughness: what distances from the arc's chord are multiplied by, besides the scale of the chords. */
  c: number;
}

/** A closed curve made of smaller copies of its own arcs: 3 to 4096 knots, counter-clockwise. */
export interface Curve {
  knots: [x: number, y: number][];
  /** What the edge from each knot to the next copies; null: it is straight. */
  edges: (CurveEdge | null)[];
}

/** One end of a morph between closed curves. `preset` is its gallery id when it is untouched. */
export interface CurveShape {
  preset?: string;
  name: string;
  /** Without knots where a link holds a `spline`. */
  curve: Curve;
  /**
   * The word of the curve of corners and parabolas that it is, which a link keeps in its place: what `splineCurve`
   * makes of it, about the origin, its longer side 2.
   */
  spline?: string;
}

export interface CurvePreset {
  id: string;
  name: string;
  /** One sentence for the gallery. */
  about: string;
  curve: Curve;
}

/** A part of a fractal function: the function over the image of `domain` is that over `domain`, mapped. */
export interface GraphPiece {
  /** t' = a t + d, x' = b t + c x + e (Cochran, Hart & Flynn, eq 1). */
  map: [a: number, b: number, c: number, d: number, e: number];
  domain: [from: number, to: number];
}

/**
 * A fractal function: pieces that are copies of all of it (FIF), of what lies between knots (RFIF), or of any part
 * (PFIF).
 */
export interface Graph {
  kind: "fif" | "rfif" | "pfif";
  /**
   * From left to right, 1 to 256. Printed numbers may leave slits of up to 1/400 of the whole, in which the nearer end
   * goes on, or make pieces overlap as much, where the right one holds.
   */
  pieces: GraphPiece[];
}

/** A part of a fractal curve: the curve over the image of `domain` is that over `domain`, mapped. */
export interface PlaneGraphPiece {
  /**
   * t' = a t + d, x' = bx t + cx x + cxy y + ex, y' = by t + cyx x + cy y + ey (Cochran, Hart & Flynn, eq 9; eq 8 where
   * cxy and cyx are 0).
   */
  map: [
    a: number,
    bx: number,
    by: number,
    cx: number,
    cxy: number,
    cyx: number,
    cy: number,
    d: number,
    ex: number,
    ey: number,
  ];
  domain: [from: number, to: number];
}

/** A fractal curve of the plane over a parameter t. */
export interface PlaneGraph {
  /** From left to right. */
  pieces: PlaneGraphPiece[];
  /** By how much all maps shrink together, at most (eq 2 with norms for factors); told, and not read. */
  contractivity?: number;
}

/** What a document says of fitting. The outline, or the photograph it was taken from, is not part of it. */
export interface Fit {
  mode: "outline" | "graph" | "plane";
  /** Frond's closed curve, the fit of Cochran, Hart & Flynn, or corners and parabolas within so many bytes. */
  model: "closed" | "collage" | "spline";
  /** How many numbers the closed curve may spend: 12 to 2000. */
  numbers: number;
  /** How many bytes corners and parabolas may take: 32 to 4000; absent: 150. */
  bytes?: number;
  /** How much an outline is smoothed before it is fitted: 0 to 1. */
  smoothing: number;
  /** The last fit by a closed curve. */
  curve?: CurveShape;
  /** The last fit by corners and parabolas. */
  spline?: SplineShape;
  graph?: Graph;
  /**
   * The last curve of the plane, in numbers: t, x, y of each point; of each piece cx, cxy, cyx, cy of its factor, and
   * from which point to which it copies, from 0, backwards where the first is the larger:
   * "0,0,0;..:0.5,0,0,0.5,0,2;..".
   */
  plane?: string;
}

/** A curve of corners and parabolas: `unpackSpline` reads its word, which is its bytes in letters. */
export interface SplineShape {
  name: string;
  word: string;
}

/**
 * How a displacement turns with the piece it is given to: not at all, by the orthogonal polar factor, by its rotation,
 * by A / ||A||.
 */
export type Spin = "none" | "orthogonal" | "rotation" | "scaled";

/**
 * What keeps neighbouring pieces together: shared corners, a splat for each level, nothing, or averages. `"published"`
 * is what the paper does (section 5.3): the mean displacement of each of the smallest pieces, over a Delaunay
 * triangulation of their middles. `"average"` is a variant that leaves the terms exact that shuffle nothing: kb and,
 * where displacements do not turn, kb + 1. `"auto"` takes what fits the shape: nothing for ferns and trees, which may
 * fray.
 */
export type Continuity = "auto" | "corners" | "splat" | "raw" | "average" | "published";

/** A fractal deformation at one moment (Fujimoto et al., eqs 12 and 18). Lengths are units of the plane. */
export interface Bend {
  /** Control points a side of the mesh, 2 to 16 each. */
  columns: number;
  rows: number;
  /** The mesh at rest: [minX, minY, maxX, maxY]. */
  box: [number, number, number, number];
  /** dx, dy of each control point, row by row from the lower left. */
  moves: number[];
  /** Locality: letters that stay. 0 to ke, whole or not (eq 19). */
  kb: number;
  /** Detail: the last letter that is shuffled. */
  ke: number;
  /**
   * Roughness, 0 or more: one number, or four at the lower left, lower right, upper left and upper right of the box.
   */
  delta: number | [number, number, number, number];
  spin: Spin;
  continuity: Continuity;
  /** The sum of all terms kb to ke (eq 12), or the last alone (eq 11). */
  superposed: boolean;
  tint?: Tint;
}

/** A colour function carried along: colours of the control points, blended and shuffled like displacements. */
export interface Tint {
  /** "#rrggbb", one a control point. */
  colours: string[];
  kb: number;
  ke: number;
  delta: number;
  superposed: boolean;
}

/** The mesh at one moment of the time line. */
export interface DeformKey {
  /** 0 to 1, below 1 where it loops. */
  at: number;
  /** As in `Bend`. */
  moves: number[];
}

/** What a document says of bending: a bend whose mesh moves in time. */
export interface Deformation extends Omit<Bend, "moves"> {
  /** Whether the morph shows it, too. */
  on: boolean;
  /** The shape of the studio, or a picture on the unit square. */
  subject: "shape" | "picture";
  /** Parts each way that the square of a picture is taken apart into. */
  parts: 2 | 3;
  /** 1 to 32, in order. One alone is the mesh at all times. */
  keys: DeformKey[];
  /** The moment: 0 to 1. */
  phase: number;
  /** How long once through takes: 0.5 to 60. */
  seconds: number;
  /** Whether the last key goes on to the first. */
  loop: boolean;
}

/** What comes of a bend on a shape. */
export interface BendFacts {
  /** What `"auto"` came to, and whether what was asked for can be had. */
  continuity: Exclude<Continuity, "auto">;
  /** As used: within what memory allows. */
  kb: number;
  ke: number;
  /** The deepest that memory allows for this shape. */
  deepest: number;
  /** No displacement is longer. */
  reach: number;
}

export interface LocusView {
  /** What is mapped: the morph's (u, v), or a polygon family's s. */
  family: "morph" | "polygon";
  /** Of the polygon family; 2 is the set M. */
  sides: number;
  /** The parameter in the middle, and the magnification over the view of all. */
  x: number;
  y: number;
  zoom: number;
  /** The slice of the morph. */
  w: number;
  /** A parameter off the path that the picture shows instead; of a polygon family, s. */
  at?: PathPoint;
}

/** Both ends brought to the same number of maps by refining or doubling, which leaves the shapes alone. */
export interface Pairing {
  from: MapRow[];
  to: MapRow[];
  /** One sentence for each step taken, empty when the numbers were equal. */
  steps: string[];
  /** Of the maps of `from` and of `to`, where one of the systems was given with probabilities. */
  probabilities?: [from: number[], to: number[]];
}

export interface IndexBufferOptions {
  /** Pixels a side, 1 to 8192. */
  size: number;
  /** Points of the chaos game, up to 1e9. */
  points: number;
  /** Default 0. */
  seed?: number;
  /**
   * By how much the window is larger than the shape, relative to it: 0 to 10. Default 0.05. Nothing beside `window`.
   */
  margin?: number;
  /** Whether the probabilities of the system count; else each map is as likely as any other. */
  weighted?: boolean;
  /**
   * What part of the plane the buffer shows: [x0, y0, x1, y1], lower left and upper right, in units of the plane. What
   * lies outside is not plotted. Default: a square about the shape. There an even number of pixels has a border in the
   * middle, through which the gasket's pieces touch: it is never seen whole at one half. A window off the middle sees
   * it.
   */
  window?: [number, number, number, number];
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

/** The Hausdorff distance of two shapes, in units of the plane. */
export interface HausdorffDistance {
  /** It is not less. */
  lower: number;
  /** It is not more. */
  upper: number;
  /** A point of the first shape and one of the second: one is at least `lower` from all of the other shape. */
  points: [[number, number], [number, number]];
}

/** A map of a graph-directed system: a copy of a state, counted from 0. */
export interface DirectedMap {
  from: number;
  map: MapRow;
}

/**
 * A graph-directed system: 1 to 64 states, each the union of 1 to 64 copies of states. State 0 is the shape that is
 * meant. An `Ifs` is the case of one state whose maps are all `from` 0. One that `gridIntersection` finds may have 1024
 * states, of 8192 maps in all; `directedFacts`, `directedAttractor` and `rasterizeDirected` take as many, what decides,
 * matches or certifies takes 64 states.
 */
export interface DirectedIfs {
  states: DirectedMap[][];
}

export interface DirectedPreset {
  id: string;
  name: string;
  about: string;
  system: DirectedIfs;
}

/**
 * One end of a morph between graph-directed shapes: a system, with its name. `preset` is its gallery id when its states
 * are untouched. A system of maps is one of a single state.
 */
export interface DirectedShape extends DirectedIfs {
  preset?: string;
  name: string;
  /** The closed curve that the states are made of, packed as in links, while they are. */
  outline?: string;
}

/** Where the states of a graph-directed system lie, and how they are made of each other. */
export interface DirectedFacts {
  /** Of each state. Its dimension, where all maps that it is made of are similitudes (Mauldin & Williams 1988). */
  states: BoundingBox[];
  /** States that state 0 is not made of. */
  unreached: number[];
  /** States that are not made of copies of themselves, at any depth. */
  neverReturn: number[];
  /** By how much all maps shrink in coordinates that suit each state. */
  factor: number;
}

export interface DirectedRasterOptions {
  width: number;
  height: number;
  /** Which state is drawn, from 0. Default 0. */
  state?: number;
  /** As of `rasterize`. Default: all of the state. */
  view?: { x: number; y: number; scale: number };
  /** Colours tell the state that is copied after so many maps, 1 to 8. Default 0: they tell the map. */
  level?: number;
  palette?: string[];
  smooth?: boolean;
}

/** What is known of one state. */
export interface StateConnectedness {
  verdict: Verdict;
  /**
   * Bounds of the widest edge of the least spanning tree between its pieces. Where it is 0 these hold together, but may
   * be in several pieces themselves; then they are split until a gap of epsilon shows, and it is between such parts, of
   * which finer ones may leave a wider gap: it may vary with epsilon.
   */
  gap: { lower: number; upper: number };
  /** Pairs of its maps whose pieces meet, or come within epsilon of each other. */
  overlaps: [number, number][];
  closest?: { from: [number, number]; to: [number, number] };
  /** Points that pieces share, exactly: the ways there through each, as maps by their place in their state, from 1. */
  links: { pair: [number, number]; words: [string, string]; at: [number, number] }[];
  /** Readings of numbers under which the state is proved to be in one piece, though not as they are given. */
  assuming: string[];
  /** States that keep it open: its pieces hold together, but some are copies of these, which may not. */
  openBy: number[];
  diameter: number;
  nodes: number;
}

/** Which state of the first system becomes which of the last, and what was done to match the graphs. */
export interface DirectedMatch {
  states: [number, number][];
  steps: string[];
  /** How many maps turn by half a turn, which is as short either way. */
  halfTurns: number;
}

/** What was shown of every moment of a way. */
export interface DirectedCertificate {
  /**
   * Of each state: connected at every moment; held by gaps no wider than this part of its diameter; or neither, the
   * first moment where it was not shown.
   */
  states: ({ kind: "connected" } | { kind: "within"; gap: number } | { kind: "open"; at: number })[];
  /** Readings of numbers that exact proofs hang on. */
  assuming: string[];
  moments: number;
}

/**
 * A shape on a grid: all that can be written with these digits after the point, in the base of a matrix. A is the union
 * of `matrix^-1 (A + d)` over the digits d.
 */
export interface DigitSystem {
  /** Whole numbers from -32 to 32, the rows (a b) and (c d); both eigenvalues are larger than 1. */
  matrix: [a: number, b: number, c: number, d: number];
  /** 1 to 64 points with whole coordinates from -1000 to 1000. */
  digits: [x: number, y: number][];
}

/** What two shapes of one grid share, as a graph-directed system of up to 1024 states. */
export interface GridIntersection {
  /** State 0 is what they share; null where they do not meet. */
  system: DirectedIfs | null;
  /**
   * Of each state: it is the part of the first shape that lies in the second moved by any of these shifts, numerators
   * over `denominator`; and its pieces, a digit of the first shape and the state that is copied there, from 0.
   */
  states: { shifts: [number, number][]; copies: { digit: number; to: number }[] }[];
  /** In lowest terms. */
  denominator: number;
  /** How many shifts lead on for ever. */
  shifts: number;
  /**
   * By the graph (Mauldin & Williams 1988): the Hausdorff dimension where `isExact`, else it is not below it. Absent
   * where they do not meet, or the matrix is no similarity.
   */
  dimension?: number;
  /** Whether the digits of the first shape leave different remainders, so that its pieces do not overlap. */
  isExact: boolean;
  /** How many addresses, and so points at most, belong to it. */
  addresses: number | "countable" | "uncountable";
  /** Where they are finitely many (of 4096 addresses at most): which, as far as rounding tells them apart. */
  points: [x: number, y: number][] | null;
  /** Maps whose attractor it is, where the graph shows some; there may be some where it does not. */
  attractor: MapRow[] | null;
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
  /**
   * Whether the picture is for a light ground: what is dense is darkened there, and else lightened. Default:
   * where the colours of the palette are dark.
   */
  lightGround?: boolean;
  /**
   * Whether a draft is enough, several times as quick: whole and smooth, without some pixels that the attractor hardly
   * reaches into. For frames of what moves. Densities are a little softer, and what is bent is off by half a pixel.
   */
  draft?: boolean;
  /** What bends the attractor. */
  bend?: Bend;
}

export interface BoundingBox {
  min: [number, number];
  max: [number, number];
  /** A convex polygon that holds the attractor, counter-clockwise. */
  hull: [number, number][];
  /** Similarity dimension, when all maps are similitudes. */
  dimension?: number;
}

/** One affine map of space: the three rows of its matrix, then its translation. Right-handed; z points up. */
export type MapRow3 = [
  xx: number,
  xy: number,
  xz: number,
  yx: number,
  yy: number,
  yz: number,
  zx: number,
  zy: number,
  zz: number,
  x: number,
  y: number,
  z: number,
];
export type Point3 = [x: number, y: number, z: number];

export interface Preset3 {
  id: string;
  name: string;
  /** One sentence for the gallery. */
  about: string;
  maps: MapRow3[];
}

/** A shape of space. `preset` is its id in the gallery, or in the natural scene, while its maps are untouched. */
export interface Shape3 {
  preset?: string;
  name: string;
  /** 1 to 64. */
  maps: MapRow3[];
}

/** A shape in its place: its parameters are `maps`, conjugated by `moved` (Darwish & Abd-El-Wahab, eq 1). */
export interface SpaceObject extends Shape3 {
  /** All that was done to it, in one transform. Absent: nothing. */
  moved?: MapRow3;
  /** "#rrggbb": one colour for all of it. Absent: its maps have theirs. */
  tint?: string;
  /** How it is bent before it is moved. Absent: not at all. */
  bend?: SpaceBend;
}

/** A fractal deformation by a lattice of control points (Fujimoto et al., in space as in the plane). */
export interface SpaceBend {
  /** Control points along x, y and z: 2 to 6. */
  sizes: [x: number, y: number, z: number];
  /** How far each is moved, in longest sides of the box around the shape: up to 10. x fastest, then y. */
  moves: Point3[];
  /** Locality: 0 to ke. */
  kb: number;
  /** Detail: 0 to 16, taken down to what memory allows. */
  ke: number;
  /** Roughness: 0 to 1.5. */
  delta: number;
  spin: Spin;
}

/** How a shape can be bent: the box that its lattice lies over, and what holds its pieces together. */
export interface BendRoom3 {
  min: Point3;
  max: Point3;
  /** Its pieces meet in corners, so that nothing tears. */
  continuous: boolean;
  /** The greatest detail that memory allows. */
  deepest: number;
}

/** What a picture shows of an object: its parameters now, and, where it is bent, what they come of. */
export interface SpaceShown {
  maps: MapRow3[];
  tint?: string;
  bent?: { maps: MapRow3[]; moved: MapRow3; bend: SpaceBend };
}

/** Where space is seen from: the eye is `distance` away from `target`, `turn` to the side of -y and `tilt` above it. */
export interface SpaceView {
  target: Point3;
  distance: number;
  /** Radians, counter-clockwise seen from above. */
  turn: number;
  /** Radians upwards. */
  tilt: number;
  /** The height of the picture, in radians: above 0 and below pi. */
  angle: number;
  /** What stays when the view is turned: the target (absent), or the eye. */
  holds?: "eye";
}

/** How a scene of space is lit and coloured. All but `paint` and `side` are 0 to 1. */
export interface SpaceLight {
  /** What colours a pixel: its map, or how high it lies. */
  paint: "map" | "height";
  /** Where the light comes from, as the eye has it: radians from straight above, positive to the right. */
  side: number;
  /** How far the light stands on the eye's side: 0 grazes, 1 is from the eye. */
  front: number;
  /** How much of the light comes from everywhere. */
  ambient: number;
  /** How dark hollows are. */
  hollows: number;
  /** How much fades into the ground colour at the farthest depth. */
  fog: number;
  /** How dark cast shadows are, 0 to 1: this and what follows is 0, or off, where it is absent. */
  shadows?: number;
  /** How soft the edges of shadows are. */
  softness?: number;
  /** How much of the light from everywhere what is around keeps off. */
  occlusion?: number;
  /** How far the light from everywhere is that of a blue sky, and the other warm. */
  sky?: number;
  /** From rough, 0, to glossy, 1. */
  gloss?: number;
  /** Whether bright tones are compressed, as on film, and not cut off. */
  filmic?: boolean;
}

/** The first object on its way to another shape (Burch & Hart, eq 6, in space). */
export interface SpaceMorph extends MorphOptions {
  to: Shape3;
  path: { kind: PathKind; points: PathPoint[] };
  /** Where along the path, by length: 0 to 1. */
  t: number;
}

export type Ease = "even" | "in" | "out" | "inout" | "hold";

/** All that is, at one moment; what is absent goes on as if there were no key here. */
export interface SpaceKey {
  /** Seconds: 0 to 600, no two alike. */
  at: number;
  /** How it goes on to the next key. */
  ease: Ease;
  view?: SpaceView;
  /** For each object what was done to it; null: nothing is said of it here. */
  moved?: (MapRow3 | null)[];
  /** For each object its maps; null: nothing is said of them here. Not for the first object of a morph. */
  maps?: (MapRow3[] | null)[];
  /**
   * For each object how far the control points of its lattice are moved; null: nothing is said of it here. What is of
   * another number of control points than the object's `bend` is passed over.
   */
  bends?: (Point3[] | null)[];
  /** Where along the path of the morph. */
  t?: number;
}

/** What comes after the end of a time line: nothing, its beginning, or the way back to that. */
export type Repeat = "once" | "round" | "pingpong";

/**
 * A time line. Between keys a transform goes by its polar factors, its turn as a quaternion. Nothing goes beyond two
 * keys between them: each number stays between theirs, and a turn within a sixth of its angle of the shortest arc.
 */
export interface SpaceTimeline {
  /** How long it is: 0.1 to 600. */
  seconds: number;
  /**
   * "round": the last key goes on to the first, and one at the very end jumps there, unless it says the same. Of older
   * documents `true` is read as "round", `false` as "once".
   */
  loop: Repeat;
  /** Straight from key to key, or without a jerk at the keys. */
  course: "straight" | "smooth";
  /** In the order of their times, at most 100. */
  keys: SpaceKey[];
}

/** What there is in space, and how it moves. */
export interface Space {
  /** 1 to 60. */
  objects: SpaceObject[];
  light: SpaceLight;
  /**
   * What it is seen before: "#rrggbb", or "page" for the colour under the pictures of whatever page shows it, as where
   * absent.
   */
  background?: string;
  /** Absent: the first object is what it is. */
  morph?: SpaceMorph;
  /** Absent: nothing moves. */
  timeline?: SpaceTimeline;
}

/** What a document says of space. */
export interface SpacePart {
  /** A `Space`, as `packSpace` of the module `frond-space` writes it. Empty: what the tool begins with. */
  packed: string;
  /** Absent: all of it is seen, from a little above. */
  view?: SpaceView;
  /** Somebody looks around: the view goes before that of the time line. */
  own?: boolean;
  /** The moment of the time line, in seconds. */
  at: number;
}

/** What all objects are at a moment: each frame is a set of parameters. */
export interface SpaceFrame {
  /**
   * Of each object the maps it is made with, what was done to it, and the parameters that come of both (eq 1); and how
   * far the control points of its lattice are moved, where the time line says so.
   */
  objects: { maps: MapRow3[]; moved: MapRow3; now: MapRow3[]; bend?: Point3[] }[];
  /** Where it is seen from; absent where no key says so. */
  view?: SpaceView;
  /** Where along the path of the morph; absent where there is none. */
  t?: number;
}

/** A transform taken apart: scaled along its own axes, then turned, then moved. */
export interface Place3 {
  shift: Point3;
  /** A unit quaternion. */
  turn: [x: number, y: number, z: number, w: number];
  scale: Point3;
  /** Whether that is all of it: it neither shears nor reflects. */
  exact: boolean;
  determinant: number;
}

/** What there is to say of a system of space. */
export interface ShapeFacts3 {
  /** The similarity dimension; null where some map is no similitude. */
  similarity: number | null;
  /** An upper bound of the dimension (Falconer 1988). */
  affinity: number;
  /** The largest factor by which a map stretches, in the coordinates in which that is least. */
  contractivity: number;
  /** A ball around all of it. */
  centre: Point3;
  radius: number;
}

/** Files of a mesh: binary STL, binary PLY and binary glTF. */
export type MeshFormat = "stl" | "ply" | "glb";

/** How a mesh is made. */
export interface MeshOptions {
  /** Samples along the longest side, 16 to 640. */
  fineness: number;
  /** The longest side, in millimetres. */
  size: number;
  /** How thick it is at least, in millimetres; three samples are the least. */
  wall?: number;
}

/** What there is to say of a mesh. */
export interface MeshFacts {
  triangles: number;
  /** In how many pieces it is. */
  parts: number;
  /** Along x, y and z, in millimetres. */
  size: Point3;
  /** In cubic millimetres. */
  volume: number;
  /** How thick it is at least, in millimetres. */
  wall: number;
}

export interface BoxCount3 {
  dimension: number;
  /** The side of the boxes and how many were met, the largest first. */
  counts: [side: number, boxes: number][];
}

/** The answer of `connectedness3`. Lengths are units of space. */
export interface Connectedness3 {
  verdict: Verdict;
  /** The widest gap: 0 if and only if it is in one piece. */
  gap: { lower: number; upper: number };
  overlaps: [number, number][];
  /** For each map the cluster of pieces that its own hangs together with. */
  components: number[];
  /** How many clusters there are: pieces may be in pieces themselves. */
  count: number;
  /** Two points of different pieces, about as far apart as the gap is wide. */
  closest: [Point3, Point3] | null;
  /** An upper bound of the diameter: epsilon is relative to it. */
  diameter: number;
  /** Why it is connected, in a sentence or two, or under which reading of its numbers it would be. */
  reason: string | null;
}

/** The shadow of a shape on a plane. */
export interface Shadow {
  /** x0, y0, x1, y1, .. in the plane. */
  points: Float32Array;
  /** What goes to the right in the picture, and what up: unit vectors. */
  right: Point3;
  up: Point3;
}

/** A shape flattened by epsilon along the direction of view (Darwish & Abd-El-Wahab, section 3.5). */
export interface EpsilonProjection {
  /**
   * In the frame that was asked for. `"space"`: the axes of the shape, as in the paper, where a scale along z is
   * diag(1, 1, epsilon). `"picture"`, the default: x to the right, y up, z along the direction, away from the eye. The
   * latter axes are left-handed: the maps are those of a mirror image, along z of the shape mirrored in x.
   */
  maps: MapRow3[];
  /** The largest entry of all matrices. */
  largest: number;
  /**
   * The entries that grow as 1 / epsilon: the map, the row of its matrix, and in the frame `"space"` the column, all
   * from 0. In the frame `"picture"` all of them stand in the third column.
   */
  diverging: [map: number, row: number, column?: number][];
}

/** What is known of where two shapes meet whose maps share one linear part. */
export interface Intersection3 {
  /** The shifts by which the shapes reach each other, the first of them 0. Empty: they do not meet. */
  shifts: Point3[];
  /** One way from a shift to the next, by a map of the first shape and one of the second. */
  arrows: { from: number; first: number; second: number; to: number }[];
  /** The maps whose attractor the intersection is; null where the construction finds none. */
  attractor: MapRow3[] | null;
  /** x0, y0, z0, x1, .. of points of it. */
  points: Float32Array;
}

export interface MeetExample {
  name: string;
  first: MapRow3[];
  second: MapRow3[];
  isAttractor: boolean;
  why: string;
}

/** What `importFile` knows. `table`: a map a line. */
export type ImportFormat = "fractint" | "flame" | "ifstile" | "json" | "table" | "png";

/** A system that was in a file. */
export type ImportedSystem = {
  /** Empty where the file gives none. */
  name: string;
  /** As the file gives them, none negative; their sum need not be 1. */
  probabilities?: number[];
  /** "#rrggbb", one a map; absent where the file gives none. */
  colours?: string[];
  /** What was left out or changed in reading it, a sentence each. */
  remarks: string[];
  /** Why it cannot be drawn; absent where it can. */
  problem?: string;
} & (
  | {
      dimension: 2;
      /** None where there are `states`. */
      maps: MapRow[];
      /** Of a graph-directed system: state 0 is the shape. */
      states?: DirectedMap[][];
      /** The view of the file: the largest disc around its middle that is seen; turned by so many degrees. */
      camera?: { centre: [x: number, y: number]; radius: number; angle: number };
    }
  | {
      dimension: 3;
      /** None where there are `objects`. */
      maps: MapRow3[];
      /** Of a shape that is several systems side by side: the maps of each. */
      objects?: MapRow3[][];
      /** The view of the file; `field` is in degrees. */
      camera?: { eye: Point3; target: Point3; up: Point3; field: number };
    }
);

/** What was in a file. */
export interface ImportedFile {
  format: ImportFormat;
  /** At most 1000. Empty where the file holds a document. */
  systems: ImportedSystem[];
  /** What is to be said of the file as a whole. */
  remarks: string[];
  /** The document that it holds, as the fragment of a link: `decodeScene` reads it. */
  link?: string;
}

/**
 * What `exportMaps` writes. JSON, Fractint, flame and CSV come back through `importFile` to the last bit, AIFS but for
 * the signs of zeros. AIFS alone takes `states`.
 */
export type ExportFormat =
  | "json"
  | "fractint"
  | "flame"
  | "aifs"
  | "csv"
  | "svg"
  | "latex"
  | "tikz"
  | "python"
  | "geogebra"
  | "desmos";

export interface ExportFormatInfo {
  id: ExportFormat;
  label: string;
  /** A sentence that says what it is for. */
  about: string;
  /** How names of such files end, without the dot. */
  extension: string;
  /** Whether maps of space can be written so. */
  space: boolean;
}
