/** The locus in words. */
import type { Connectedness } from "../../engine/api";
import { STATE } from "../../engine/breaks";
import { gapWords } from "../../state/morph-words";
import type { Uv } from "../../state/path";
import { fixed, formatNumber } from "../../ui/number";

const RAISED: Record<string, string> = {
  "-": "⁻",
  "0": "⁰",
  "1": "¹",
  "2": "²",
  "3": "³",
  "4": "⁴",
  "5": "⁵",
  "6": "⁶",
  "7": "⁷",
  "8": "⁸",
  "9": "⁹",
};
const LOWERED = "₀₁₂₃₄₅₆₇₈₉";

export const raised = (n: number): string => [...String(n)].map((c) => RAISED[c] ?? c).join("");
export const lowered = (n: number): string => [...String(n)].map((c) => LOWERED[Number(c)] ?? c).join("");

/** 4.1 × 10⁵; small powers are written out. */
export function powerWords(x: number): string {
  if (!Number.isFinite(x) || x === 0) return formatNumber(x);
  const size = Math.abs(x);
  if (size >= 0.001 && size < 1e5) return formatNumber(x, size < 10 ? 3 - Math.floor(Math.log10(size)) : 0);
  const [mantissa = "", exponent = "0"] = x.toExponential(1).split("e");
  const digits = Number(mantissa) === 1 ? "" : `${String(Number(mantissa)).replace("-", "−")} × `;
  return `${digits}10${raised(Number(exponent))}`;
}

/** ×1, ×2.5, ×1400, ×4.1 × 10⁵ */
export function zoomWords(zoom: number): string {
  if (zoom < 10) return `×${formatNumber(zoom, 1)}`;
  return zoom < 1e5 ? `×${Math.round(zoom)}` : `× ${powerWords(zoom)}`;
}

/** What counts as touching: a part of the shape. */
export function epsilonWords(epsilon: number): string {
  const whole = Math.round(1 / epsilon);
  if (whole >= 1e6) return powerWords(epsilon);
  return whole < 1e4
    ? `1/${whole}`
    : `1/${Math.floor(whole / 1000)} ${String(whole % 1000).padStart(3, "0")}`;
}

/** A gap as a part of the shape: in hundredths, or, where that is too fine, as a power of ten. */
export const partWords = (gap: number): string =>
  gap >= 0.00095 ? `${formatNumber(100 * gap, 1)}%` : powerWords(gap);

/** a + b i */
export function complexWords([re, im]: Uv, digits: number): string {
  const sign = im < 0 ? "−" : "+";
  return `${fixed(re, digits)} ${sign} ${fixed(Math.abs(im), digits)} i`;
}

/** What a sample of the map says. */
export function sampleWords(state: number, gap: number, epsilon: number): string {
  switch (state) {
    case STATE.connected:
      return "in one piece, proved";
    case STATE.touching:
      return `in one piece, to ${epsilonWords(epsilon)}`;
    case STATE.disconnected:
      return `broken, gap ${partWords(gap)} of the shape`;
    case STATE.undecided:
      return "not decided";
    case STATE.none:
      return "no shape";
    default:
      return "not looked at yet";
  }
}

/** What is known of one parameter, as a person would say it. Only a proof is said to be one. */
export function knownWords({ verdict, gap, diameter, count }: Connectedness, epsilon: number): string {
  switch (verdict) {
    case "connected":
      return "In one piece, proved";
    case "touching":
      return `In one piece, to ${epsilonWords(epsilon)}`;
    case "disconnected":
      if (gap.upper <= epsilon * diameter) return `In one piece, to ${epsilonWords(epsilon)}`;
      return `${count} pieces, gap ${gapWords(gap.upper / diameter)}`;
    case "undecided":
      return "Not decided";
    case "no-attractor":
      return "No shape here";
  }
}
