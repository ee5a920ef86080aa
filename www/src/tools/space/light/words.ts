/** What the settings of light come to, in words. Pure. */

import { formatNumber } from "#format/numbers";
import type { Point3 } from "#wasm/api";

const DEGREE = Math.PI / 180;

export const degrees = (radians: number): number => radians / DEGREE;
export const radians = (degrees: number): number => degrees * DEGREE;

/** Where the light comes from, as the eye has it. */
export function sideWords(side: number): string {
  const d = Math.round(degrees(side));
  if (Math.abs(d) < 5) return "from above";
  if (Math.abs(d) > 175) return "from below";
  const way = d > 0 ? "right" : "left";
  const at = Math.abs(d);
  if (at < 60) return `from above, ${at}° to the ${way}`;
  if (at <= 120) return `from the ${way}`;
  return `from below, ${180 - at}° to the ${way}`;
}

/** How far the light stands on the eye's side. */
export function frontWords(front: number): string {
  if (front < 0.15) return "grazing";
  if (front > 0.85) return "from the eye";
  return `${Math.round(100 * front)} % on the eye's side`;
}

export function shareWords(share: number, none: string): string {
  return share === 0 ? none : `${Math.round(100 * share)} %`;
}

export function pointWords(point: Point3): string {
  // What is nearly zero is zero: nobody reads 1e-17.
  const size = Math.max(1, ...point.map(Math.abs));
  return `(${point.map((x) => formatNumber(Math.abs(x) < 1e-6 * size ? 0 : x, 3)).join(", ")})`;
}
