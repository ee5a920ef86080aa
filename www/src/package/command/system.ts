/** What the system gives the command: modules, workers, files and somebody who reads. */
import type { Locus, PathCertificate, PathPlan } from "#wasm/api";
import type { MeasuredCurve, SplineMeasured } from "#workers/fit/curve";
import type { Frame, IndexedFrame, PngFrame } from "./draw/frame";
import type {
  Curves,
  Directed,
  Draw,
  Drawings,
  Exact,
  Exchange,
  Fitting,
  Pixels,
  Proof,
  Solid,
  Tables,
} from "./modules";

interface How {
  onProgress(share: number): void;
}

export interface Pool {
  size: number;
  /** A number that no other frames have. */
  key(): number;
  pixels(frame: Frame): Promise<Pixels>;
  png(frame: PngFrame): Promise<Uint8Array<ArrayBuffer>>;
  indices(frame: IndexedFrame): Promise<Uint8Array<ArrayBuffer>>;
  planPath(...args: Parameters<Proof["planPath"]>): Promise<PathPlan>;
  certifyPath(...args: Parameters<Proof["certifyPath"]>): Promise<PathCertificate>;
  connectedness(...args: Parameters<Proof["connectedness"]>): Promise<ReturnType<Proof["connectedness"]>>;
  hausdorffDistance(
    ...args: Parameters<Proof["hausdorffDistance"]>
  ): Promise<ReturnType<Proof["hausdorffDistance"]>>;
  certificate(...args: Parameters<Proof["certificate"]>): Promise<ReturnType<Proof["certificate"]>>;
  connectedCertificate(
    ...args: Parameters<Proof["connectedCertificate"]>
  ): Promise<ReturnType<Proof["connectedCertificate"]>>;
  locus(...args: [...Parameters<Proof["locus"]>, How]): Promise<Locus>;
  fitCurve(outline: Float64Array, options: { numbers: number }, how: How): Promise<MeasuredCurve>;
  fitWithin(outline: Float64Array, bytes: number, how: How): Promise<SplineMeasured>;
}

export type VideoKind = "mp4" | "webm" | "mov";

export interface Video {
  kind: VideoKind;
  width: number;
  height: number;
  fps: number;
  /** Fills up sides to even numbers, which videos have to have. */
  ground: string;
}

/** A program that makes a video of frames, which it is handed one by one. */
export interface Encoder {
  add(pixels: Pixels): Promise<void>;
  /** Throws what the program says where it could not make the video. */
  finish(): Promise<void>;
}

/** Files are named as they are on the disk; "-" is the standard input or output. */
export interface System {
  /** Of the package. */
  version: string;
  draw(): Promise<Draw>;
  proof(): Promise<Proof>;
  exchange(): Promise<Exchange>;
  exact(): Promise<Exact>;
  directed(): Promise<Directed>;
  space(): Promise<Solid>;
  curve(): Promise<Curves>;
  fit(): Promise<Fitting>;
  tables(): Promise<Tables>;
  drawings(): Promise<Drawings>;
  /** Of so many workers, where it is asked for first; else of as many as there are cores. */
  pool(size?: number): Pool;
  read(file: string): Promise<Uint8Array>;
  /** What is in a file; null where there is none. */
  present(file: string): Promise<Uint8Array | null>;
  /** The file is whole, or it is not there. */
  write(file: string, bytes: Uint8Array | string): Promise<void>;
  /** Throws where the file could not be written: before the work, not after it. */
  writable(file: string): Promise<void>;
  /** Whether there is a program that makes videos. */
  encodes(): Promise<boolean>;
  /** The file is written by the program. */
  encoder(file: string, video: Video): Promise<Encoder>;
  print(line: string): void;
  /** What is said while it works, and is no answer. */
  tell(line: string): void;
  /** Puts these words in place of those that it put there before, where somebody watches; absent where nobody does. */
  rewrite?: (words: string) => void;
  /** Milliseconds since whenever. */
  now(): number;
}
