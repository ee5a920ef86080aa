/** How near fits are, in words. */

import * as messages from "./messages";
import { fixed } from "./numbers";

/** In percent of the diagonal, with as many digits as say something. */
export function percent(x: number): string {
  if (!Number.isFinite(x)) return "–";
  return `${fixed(x, x < 0.1 ? 4 : x < 1 ? 3 : 2)}%`;
}

/** Errors below this are rounding: they are written as 0. Their ratio says nothing. */
const ROUNDING = 5e-5;

/** A fit beside the nearest of the others, which it names. Errors are in percent of the diagonal. */
export function nearestWords(own: number, others: readonly { name: string; rms: number }[]): string {
  const [nearest] = [...others].sort((a, b) => a.rms - b.rms);
  if (!nearest) return "";
  const plain = nearest.name.charAt(0).toLowerCase() + nearest.name.slice(1);
  if (nearest.rms < ROUNDING && own < ROUNDING) return messages.bothExact(plain);
  if (own < ROUNDING) return messages.exactBut(plain, percent(nearest.rms));
  const ratio = nearest.rms / own;
  if (ratio >= 1.05) return messages.timesAsAccurate(fixed(ratio, 1), plain);
  if (ratio > 0.95) return messages.aboutAsAccurate(plain);
  return messages.lessAccurate(plain, percent(nearest.rms));
}
