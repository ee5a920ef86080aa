/** Why samples of the map only look whole: some of them are looked at closer. */
import { resolutionWords } from "#format/verdict";
import type { Uv } from "#geometry/path";
import { STATE } from "#geometry/states";
import type { Bounds } from "#wasm/api";
import type { Cause } from "#workers/pool/protocol";
import * as messages from "../messages";

/** So many times closer. */
export const CLOSER = 1e-3;
/** Samples that are looked at: enough to tell what is common from what is rare. */
const MOST = 48;

interface Sampled {
  width: number;
  height: number;
  state: ArrayLike<number>;
  bounds: Bounds;
}

/** What was found of a map, and of which one. */
export interface Looked {
  causes: Cause[];
  of: number;
  /** The morph, as one value. */
  inputs: object;
  /** The part of its map, and how near pieces count as touching. */
  where: string;
}

/** The same of the map that is shown now; null of any other. */
export const isOf = (found: Looked | null, inputs: object, where: string): Looked | null =>
  found?.inputs === inputs && found.where === where ? found : null;

/** Samples that only look whole, evenly chosen from all of them. */
export function chosen({ width, height, state, bounds: { u0, v0, u1, v1 } }: Sampled): Uv[] {
  const all: number[] = [];
  for (let i = 0; i < width * height; i++) if (state[i] === STATE.touching) all.push(i);
  const count = Math.min(MOST, all.length);
  const at = (low: number, high: number, k: number, of: number) =>
    low + ((high - low) * k) / Math.max(1, of - 1);
  return Array.from({ length: count }, (_, k) => {
    const i = all[Math.floor(((k + 0.5) * all.length) / count)] ?? 0;
    return [at(u0, u1, i % width, width), at(v0, v1, Math.floor(i / width), height)];
  });
}

/** Each cause with its count, the most common first. */
export function counted(causes: readonly Cause[]): [cause: Cause, count: number][] {
  const counts = new Map<Cause, number>();
  for (const cause of causes) counts.set(cause, (counts.get(cause) ?? 0) + 1);
  return [...counts].sort((a, b) => b[1] - a[1]);
}

/** A cause in words, where pieces within `epsilon` of the diameter counted as touching. */
export function causeWords(cause: Cause, epsilon: number): string {
  switch (cause) {
    case "apart":
      return messages.narrowerGap(resolutionWords(epsilon));
    case "search":
      return messages.inOnePieceLonger;
    case "rounding":
      return messages.sharingPointsIfDecimals;
    case "near":
      return messages.stillNoGap(resolutionWords(CLOSER * epsilon));
    case "open":
      return messages.stillOpen(resolutionWords(CLOSER * epsilon));
  }
}
