/** The map of this lesson: which shapes it lies between, what is marked on it, and what its exercises ask for. */

import { shareOf, type VerdictWords, verdictWords } from "#format/verdict";
import type { Uv } from "#geometry/path";
import { STATE } from "#geometry/states";
import type { Connectedness } from "#wasm/api";
import { preset } from "../../kit/frame/studio-link";
import type { Ends } from "../../kit/maps/morphs";

export const FROM = "dragon-3";
export const TO = "gasket";

let kept: Ends | null = null;

/** Both shapes, read from the gallery once. */
export function ends(): Ends {
  kept ??= { from: preset(FROM).maps, to: preset(TO).maps };
  return kept;
}

export type Which = "1" | "2" | "3" | "none";

/** What is asked about: beside the second shape, half-way on the straight line, and far from both. */
export const MARKED: readonly { name: Exclude<Which, "none">; at: Uv }[] = [
  { name: "1", at: [0.9, 0.9] },
  { name: "2", at: [0.5, 0.5] },
  { name: "3", at: [0.5, 1.75] },
];
/** The one of them that is in one piece. */
export const TRUTH: Which = "3";

/** What is left of a verdict on a map. */
export type Mark = VerdictWords["tone"];

export const markOf = (answer: Connectedness): Mark => verdictWords(answer).tone;

export interface Touch {
  at: Uv;
  mark: Mark;
}

/** So many marks are kept: the oldest go. */
const MOST_TOUCHES = 300;
/** Of touches in one cell of such a grid only the latest is kept. */
const CELL = 0.05;

/** The touches with one more. */
export function touched(before: readonly Touch[], next: Touch): Touch[] {
  const cell = ([u, v]: Uv) => `${Math.floor(u / CELL)} ${Math.floor(v / CELL)}`;
  const own = cell(next.at);
  return [...before.filter(({ at }) => cell(at) !== own), next].slice(-MOST_TOUCHES);
}

/** In the first exercise the gap is to be narrower than this part of the shape. */
export const NARROW = 0.005;

export function isNarrow(answer: Connectedness): boolean {
  return answer.verdict === "disconnected" && shareOf(answer) < NARROW;
}

/** In the second the border is looked for along this line, in such steps, to within so many. */
export const LINE = { v: 0.5, u0: 0, u1: 0.5, step: 0.001 };
export const WITHIN = 0.002;

/** Whether one place is proved whole, the other proved in pieces, and both are near to each other. */
export function isBorder(places: readonly [number, number], answers: readonly (Connectedness | null)[]) {
  const verdicts = answers.map((answer) => answer?.verdict).sort();
  const apart = Math.abs(places[0] - places[1]);
  return verdicts[0] === "connected" && verdicts[1] === "disconnected" && apart <= WITHIN + 1e-9;
}

/** Where a map says that a shape looks whole and nothing proves it, as u and v. */
export function unproved({
  width,
  height,
  state,
  bounds,
}: {
  width: number;
  height: number;
  state: ArrayLike<number>;
  bounds: { u0: number; v0: number; u1: number; v1: number };
}): Uv[] {
  const found: Uv[] = [];
  for (let i = 0; i < width * height; i++) {
    if (state[i] !== STATE.touching) continue;
    const [column, row] = [i % width, Math.floor(i / width)];
    // Samples are the middles of the pixels they are drawn as.
    found.push([
      bounds.u0 + ((column + 0.5) / width) * (bounds.u1 - bounds.u0),
      bounds.v0 + ((row + 0.5) / height) * (bounds.v1 - bounds.v0),
    ]);
  }
  return found;
}
