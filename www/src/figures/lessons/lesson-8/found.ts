/** What the exercises take for found. */
import type { Connectedness } from "#wasm/api";
import type { Complex } from "../../kit/locus/set-m";

/** From this size on, and still dust. */
export const LARGE = 0.7;
/** To this size, and yet in one piece. */
export const SMALL = 0.5;
/** Rounding of hundredths. */
const EXACT = 1e-9;

export function isLargeDust(s: Complex, answer: Connectedness): boolean {
  return Math.hypot(...s) > LARGE - EXACT && answer.verdict === "disconnected";
}

export function isSmallPiece(s: Complex, answer: Connectedness): boolean {
  return Math.hypot(...s) < SMALL + EXACT && answer.verdict === "connected";
}
