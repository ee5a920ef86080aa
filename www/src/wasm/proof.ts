import wasmUrl from "../../pkg/frond-proof_bg.wasm?url";
import type {
  BarnsleyTest,
  Bounds,
  Candidate,
  Certificate,
  CertificateCheck,
  CertifyOptions,
  Connectedness,
  FamilyOptions,
  Ifs,
  IndexBuffer,
  IndexBufferOptions,
  Locus,
  LocusOptions,
  MorphOptions,
  PathCertificate,
  PathCheck,
  PathOptions,
  PathPlan,
  PathPoint,
  PolygonFamily,
  RatedCandidate,
  Route,
} from "./api";
import { compiled, once } from "./module";

/** Parts of a locus, of a morph or of a polygon family. */
export interface LocusTiles {
  /** Rows, decided coarse to fine without ever repeating a sample. */
  run(r0: number, r1: number, stride: number, first: boolean): { state: Uint8Array; gap: Float32Array };
  /** All samples of a rectangle, row by row: whole boxes are decided at once. */
  patch(x0: number, y0: number, x1: number, y1: number): { state: Uint8Array; gap: Float32Array };
  free(): void;
}

/** A search for a path, in parts. */
export interface PathSearch {
  /** Does the next part; the plan comes with the last. */
  step(): PathPlan | null;
  free(): void;
}

/** What decides and proves, in a module of its own: the workers have it, and who asks for it. */
export interface Proof {
  connectedness(ifs: Ifs, options?: { epsilon?: number; budget?: number }): Connectedness;
  indexBuffer(ifs: Ifs, options: IndexBufferOptions): IndexBuffer;
  barnsleyTest(ifs: Ifs, options: { iterations: number }): BarnsleyTest;
  locus(from: Ifs, to: Ifs, options: LocusOptions): Locus;
  /** A proof of disconnection; null where there is none to be had. */
  certificate(ifs: Ifs, options?: { epsilon?: number; budget?: number }): Certificate | null;
  /** Replays a proof in exact arithmetic. Never throws for a wrong proof: it says what is wrong with it. */
  checkCertificate(certificate: Certificate): CertificateCheck;
  planPath(from: Ifs, to: Ifs, options?: PathOptions): PathPlan;
  PathSearch: new (from: Ifs, to: Ifs, options?: PathOptions) => PathSearch;
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
  LocusTiles: new (from: Ifs, to: Ifs, options: LocusOptions) => LocusTiles;
  FamilyTiles: new (family: PolygonFamily, options: FamilyOptions) => LocusTiles;
}

/** Fetches and compiles; the workers are given the module. */
export const compileProof = once(() => compiled(wasmUrl));

let here: Proof | null = null;

/** Has it on this thread too: where there are no workers, and for what is small enough to be done at once. */
export const loadProof = once(async (): Promise<Proof> => {
  const [bindings, module] = await Promise.all([import("../../pkg/frond-proof.js"), compileProof()]);
  await bindings.default({ module_or_path: module });
  here = bindings as unknown as Proof;
  return here;
});

/** For those who come after `loadProof`. */
export function prover(): Proof {
  if (!here) throw new Error("What decides and proves is not loaded on this thread.");
  return here;
}
