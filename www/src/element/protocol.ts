/** What a page and its drawing workers say to each other. */
import type { Connectedness, PathPlan } from "#wasm/api";
import type { Proof } from "./proof";
import { errorOf } from "./trouble";

/** A picture: of which morph, where on its way, and of what part of the plane. */
export interface Drawing {
  fragment: string;
  /** u, v and w. */
  at: readonly [number, number, number];
  width: number;
  height: number;
  /** The world point in the middle, and pixels a unit. */
  view: { x: number; y: number; scale: number };
  /** Whole numbers, 0xrrggbb. */
  palette: number[];
}

/** What is decided, by the module that proves, which is fetched for it. */
export interface Question {
  proof: Proof;
  maps: number[][];
  /** For a way from `maps` to these; without them, whether `maps` hold together. */
  to?: number[][];
  mode?: string;
  turns?: number[];
}

export type Job = { kind: "draw"; drawing: Drawing } | { kind: "ask"; question: Question };
export type Answer<J extends Job> = J extends { kind: "draw" } ? Uint8ClampedArray<ArrayBuffer> : Decided;
export type Decided = { plan: PathPlan } | { connectedness: Connectedness };

export interface Failure {
  code: string;
  message: string;
}

/** A worker has one job at a time. */
export type ToWorker = { module: WebAssembly.Module } | { job: Job };
export type FromWorker = { result?: unknown; failure?: Failure };

/** What was thrown, so that it can be sent. */
export function failureOf(problem: unknown): Failure {
  const { code, message } = errorOf(problem);
  return { code, message };
}
