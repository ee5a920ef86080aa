/** The locus in words. */
import type { Uv } from "#geometry/path";
import { fixed, formatNumber } from "./numbers";
import { powerWords } from "./verdict";

const LOWERED = "₀₁₂₃₄₅₆₇₈₉";

export const lowered = (n: number): string => [...String(n)].map((c) => LOWERED[Number(c)] ?? c).join("");

/** ×1, ×2.5, ×1400, ×4.1 × 10⁵ */
export function zoomWords(zoom: number): string {
  if (zoom < 10) return `×${formatNumber(zoom, 1)}`;
  return zoom < 1e5 ? `×${Math.round(zoom)}` : `× ${powerWords(zoom)}`;
}

/** a + b i */
export function complexWords([re, im]: Uv, digits: number): string {
  const sign = im < 0 ? "−" : "+";
  return `${fixed(re, digits)} ${sign} ${fixed(Math.abs(im), digits)} i`;
}
