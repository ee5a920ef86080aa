import { keyNear } from "#document/deform/keys";
import { formatNumber } from "#format/numbers";
import type { Deformation } from "#wasm/api";
import * as messages from "../messages";

type Line = Pick<Deformation, "keys" | "loop" | "phase">;

export const percentWords = (at: number): string => `${formatNumber(100 * at, 1)}%`;

/** Where in time, and whether there is a key. */
export function momentWords(line: Line): string {
  const near = keyNear(line, line.phase);
  if (line.keys.length < 2) return messages.nothingMoves(percentWords(line.phase));
  const key = near < 0 ? messages.betweenKeyframes : messages.keyCount(near + 1, line.keys.length);
  return `${percentWords(line.phase)}, ${key}`;
}
