import { keyNear } from "#document/deform/keys";
import { formatNumber } from "#format/numbers";
import type { Deformation } from "#wasm/api";

type Line = Pick<Deformation, "keys" | "loop" | "phase">;

export const percentWords = (at: number): string => `${formatNumber(100 * at, 1)}%`;

/** Where in time, and whether there is a key. */
export function momentWords(line: Line): string {
  const near = keyNear(line, line.phase);
  if (line.keys.length < 2) return `${percentWords(line.phase)}, nothing moves`;
  const key = near < 0 ? "between key frames" : `key frame ${near + 1} of ${line.keys.length}`;
  return `${percentWords(line.phase)}, ${key}`;
}
