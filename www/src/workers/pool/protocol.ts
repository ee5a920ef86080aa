/** What is asked of the workers of the plane, what they answer, and how work is cut into slices. */
import type { Told } from "#format/verdict";
import type {
  Analysis,
  Bounds,
  Candidate,
  Certificate,
  CertificateCheck,
  CertifyOptions,
  ConnectedCertificate,
  Connectedness,
  ExactProof,
  FamilyOptions,
  FrondError,
  Ifs,
  IndexBufferOptions,
  Locus,
  LocusOptions,
  MapRow,
  MorphOptions,
  PathCertificate,
  PathOptions,
  PathPlan,
  PathPoint,
  RasterOptions,
  RatedCandidate,
  Route,
} from "#wasm/api";

/**
 * What can be asked of a worker, by kind. Every task is one slice: some ten milliseconds of work, unless it says so.
 */
export interface Tasks {
  /** Rows of a locus. `key` tells loci apart, so that a worker prepares each only once. */
  locus: {
    kind: "locus";
    key: number;
    from: MapRow[];
    to: MapRow[];
    options: LocusOptions;
    r0: number;
    r1: number;
    stride: number;
    first: boolean;
  };
  /** All samples of a rectangle of a locus, adaptively. With `sides` the locus is that of a polygon family. */
  patch: {
    kind: "patch";
    key: number;
    of: { from: MapRow[]; to: MapRow[]; options: LocusOptions } | { sides: number; options: FamilyOptions };
    x0: number;
    y0: number;
    x1: number;
    y1: number;
  };
  /** Proofs for what `state` says only touches in a rectangle of such a locus. */
  prove: Omit<Tasks["patch"], "kind"> & { kind: "prove"; state: Uint8Array };
  /** From the samples alone; with `refine` it looks between them, and straightens what it can. */
  plan: {
    kind: "plan";
    locus: Locus;
    bounds: Bounds;
    refine?: { from: MapRow[]; to: MapRow[]; options: MorphOptions & { epsilon: number; samples?: number } };
  };
  /** `polygon`: the maps are those of this family. */
  verdict: { kind: "verdict"; maps: MapRow[]; epsilon: number; polygon?: { sides: number; s: PathPoint } };
  /** The state of the morph at single points of the (u, v) plane. */
  states: {
    kind: "states";
    from: MapRow[];
    to: MapRow[];
    options: MorphOptions & { epsilon: number };
    points: readonly PathPoint[];
  };
  /** Why nothing was proved at single points where the morph only looks whole. */
  causes: {
    kind: "causes";
    from: MapRow[];
    to: MapRow[];
    options: MorphOptions & { epsilon: number };
    points: readonly PathPoint[];
  };
  /** All that is known at single points, as `verdict` tells it. */
  along: {
    kind: "along";
    from: MapRow[];
    to: MapRow[];
    options: MorphOptions & { epsilon: number };
    points: readonly PathPoint[];
  };
  /** A path through three parameters, found from nothing: a long task, which breathes. */
  plan3: { kind: "plan3"; from: MapRow[]; to: MapRow[]; options: PathOptions };
  /** What is proved of a stretch of a path. */
  certify: {
    kind: "certify";
    from: MapRow[];
    to: MapRow[];
    points: readonly PathPoint[];
    options: CertifyOptions;
  };
  /** A proof that a shape is in one piece, or in several, and what the checker says of it; null where there is none. */
  certificate: { kind: "certificate"; maps: MapRow[]; epsilon: number; connected: boolean };
  /** The same about maps some of whose entries mean numbers that are no doubles. */
  exact: {
    kind: "exact";
    module: WebAssembly.Module;
    maps: MapRow[];
    numbers: readonly string[];
    epsilon: number;
  };
  /** Neighbours, open set condition, dimension and boundary of such maps. */
  analysis: { kind: "analysis"; module: WebAssembly.Module; maps: MapRow[]; numbers: readonly string[] };
  candidates: { kind: "candidates"; from: MapRow[]; to: MapRow[]; limit: number };
  rate: {
    kind: "rate";
    from: MapRow[];
    to: MapRow[];
    options: MorphOptions & { size?: number; epsilon?: number };
  };
  routes: { kind: "routes"; from: Ifs; to: Ifs };
  /** All ways that are worth trying. */
  ways: { kind: "ways"; from: Ifs; to: Ifs; limit: number };
  /**
   * The best path of a way, or the straight one. A coarse look takes some hundredths of a second; a close one, which a
   * way that seems to hold always has, a second or more.
   */
  way: {
    kind: "way";
    from: MapRow[];
    to: MapRow[];
    options: MorphOptions & { epsilon: number };
    straight: boolean;
    closely: boolean;
  };
  picture: {
    kind: "picture";
    maps: MapRow[];
    weights?: number[] | undefined;
    options: RasterOptions;
    /** See `bendsFor`. */
    bends?: WebAssembly.Module | undefined;
  };
  /** What an index buffer says; its pixels stay behind. */
  buffer: { kind: "buffer"; ifs: Ifs; options: IndexBufferOptions };
}

/**
 * Why a sample only looks whole, seen closer: it is in pieces; a longer search proves that it is in one; its pieces
 * share points but for rounding; they come nearer, and no more is known; or not even that.
 */
export type Cause = "apart" | "search" | "rounding" | "near" | "open";

interface Results {
  /** Full rows r0, r0 + stride, .. below r1; samples that were not asked for are 255 and NaN. */
  locus: { state: Uint8Array; gap: Float32Array };
  patch: { state: Uint8Array; gap: Float32Array };
  prove: Uint8Array;
  plan: PathPlan;
  plan3: PathPlan;
  certify: PathCertificate;
  certificate: { certificate: Certificate | ConnectedCertificate; check: CertificateCheck } | null;
  exact: ExactProof & { check: CertificateCheck | null };
  analysis: Analysis;
  candidates: Candidate[];
  rate: RatedCandidate;
  routes: Route[];
  ways: Route[];
  way: PathPlan;
  verdict: Connectedness;
  states: Uint8Array;
  causes: Cause[];
  along: Told[];
  picture: ImageBitmap;
  buffer: { components: number[]; overlaps: [number, number][] };
}

export type Kind = keyof Tasks;
export type Task<K extends Kind = Kind> = Tasks[K];
export type Result<K extends Kind = Kind> = Results[K];

/** What describes and draws, and what decides and proves. */
export interface Modules {
  page: WebAssembly.Module;
  proof: WebAssembly.Module;
}

/** The latest request of a channel replaces the one before it. */
export type Channel =
  | "locus"
  | "proofs"
  | "plan"
  | "plan3"
  | "verdict"
  | "breaks"
  | "strip"
  | "thumbnails"
  | "export"
  | "certify"
  | "certificate"
  | "exact"
  | "analysis"
  | "closer"
  | "candidates"
  | "routes"
  | "ways"
  | "recall"
  | "boundary"
  | "causes"
  | "hover"
  | "describe"
  | "card"
  | "window"
  | "window-proofs"
  | "scale"
  | `figure:${string}`;

/** Work of one channel: a source of slices, handed out one by one as workers come free. */
export interface Job<K extends Kind = Kind> {
  channel: Channel;
  /** Larger goes first. Asked before each slice, so that it may fall as the work goes on. */
  priority(): number;
  /** The next slice, or null when all are handed out. */
  next(): Task<K> | null;
  accept(task: Task<K>, result: Result<K>, milliseconds: number): void;
  /** A slice that cannot be done. The others go on. */
  fail(task: Task<K>, error: FrondError): void;
  /** All slices are accepted or failed. Not called for a job that was replaced. */
  done?(): void;
}

/** A job of a single slice. */
export function single<K extends Kind>(
  channel: Channel,
  priority: number,
  task: Task<K>,
  then: { accept(result: Result<K>): void; fail(error: FrondError): void },
): Job<K> {
  let handed = false;
  return {
    channel,
    priority: () => priority,
    next: () => {
      if (handed) return null;
      handed = true;
      return task;
    },
    accept: (_, result) => then.accept(result),
    fail: (_, error) => then.fail(error),
  };
}
