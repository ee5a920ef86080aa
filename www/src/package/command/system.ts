/** What the system gives the command: modules, workers, files and somebody who reads. */
import type { Ifs, Locus, MapRow3, PathPlan, SpaceLight, SpaceView } from "#wasm/api";

export type Draw = typeof import("../../../pkg/frond.js");
export type Proof = typeof import("../../../pkg/frond-proof.js");
export type Exchange = typeof import("../../../pkg/frond-exchange.js");
export type Directed = typeof import("../../../pkg/frond-directed.js");
export type Solid = typeof import("../../../pkg/frond-space.js");
export type Pixels = Uint8ClampedArray<ArrayBuffer>;

export interface Picture3 {
  objects: { maps: MapRow3[]; tint?: string }[];
  view: SpaceView;
  light: SpaceLight;
  look: { width: number; height: number; factor: number; palette: string[]; ground: string };
}

interface Pool {
  size: number;
  rasterize(ifs: Ifs, options: Parameters<Draw["rasterize"]>[1]): Promise<Pixels>;
  rasterize3(picture: Picture3): Promise<Pixels>;
  planPath(...args: Parameters<Proof["planPath"]>): Promise<PathPlan>;
  connectedness(...args: Parameters<Proof["connectedness"]>): Promise<ReturnType<Proof["connectedness"]>>;
  locus(...args: [...Parameters<Proof["locus"]>, { onProgress(share: number): void }]): Promise<Locus>;
}

/** A program that makes a video of frames, which it is handed one by one. */
export interface Encoder {
  add(pixels: Pixels): Promise<void>;
  /** Throws what the program says where it could not make the video. */
  finish(): Promise<void>;
}

export interface System {
  draw(): Promise<Draw>;
  proof(): Promise<Proof>;
  exchange(): Promise<Exchange>;
  directed(): Promise<Directed>;
  space(): Promise<Solid>;
  pool(): Pool;
  read(file: string): Promise<Uint8Array>;
  write(file: string, bytes: Uint8Array | string): Promise<void>;
  /** Throws where the file could not be written: before the work, not after it. */
  writable(file: string): Promise<void>;
  /** Whether there is a program that makes videos. */
  encodes(): Promise<boolean>;
  /** The file is written by the program; `ground` fills up sides to even numbers, which videos have to have. */
  encoder(
    file: string,
    video: { width: number; height: number; fps: number; ground: string },
  ): Promise<Encoder>;
  print(line: string): void;
  /** What is said while it works, and is no answer. */
  tell(line: string): void;
}
