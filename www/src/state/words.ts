import type { Connectedness } from "../engine/api";

/** A length in plane units with two figures that count: 0.021, 1.4, 2.1e-6. */
export function lengthWords(length: number): string {
  if (!Number.isFinite(length)) return "";
  if (length === 0) return "0";
  const size = Math.abs(length);
  if (size < 1e-4 || size >= 1e5) return length.toExponential(1);
  const digits = Math.max(0, 1 - Math.floor(Math.log10(size)));
  return length.toFixed(Math.min(6, digits));
}

/** 950, 12 k, 1.0 M, 20 M. */
export function countWords(count: number): string {
  if (count < 1000) return String(Math.round(count));
  if (count < 1e6) return `${Math.round(count / 1e3)} k`;
  return `${(count / 1e6).toFixed(count < 1e7 ? 1 : 0)} M`;
}

/** What a picture of 600 pixels resolves, as a part of the diameter. */
const RESOLUTION = 1 / 600;

export interface VerdictWords {
  /** One of four: a state is never told by colour alone. */
  tone: "whole" | "close" | "broken" | "unknown";
  text: string;
  aside: string;
}

/** The verdict as a person would say it, of the plane or of space. Only a proof is said to be one. */
export function verdictWords(
  answer: Pick<Connectedness, "verdict" | "gap" | "count" | "diameter">,
): VerdictWords {
  switch (answer.verdict) {
    case "connected":
      return { tone: "whole", text: "In one piece", aside: "proved" };
    case "touching":
      return { tone: "close", text: "In one piece", aside: "at 600 px" };
    case "disconnected":
      // Proved apart, and yet nearer than the resolution at which everything else on the page is judged.
      if (answer.gap.upper <= RESOLUTION * answer.diameter) {
        return {
          tone: "close",
          text: "In one piece",
          aside: `at 600 px, gap ${lengthWords(answer.gap.upper)}`,
        };
      }
      return {
        tone: "broken",
        text: answer.count === 2 ? "2 pieces" : `${answer.count} pieces`,
        aside: `widest gap ${lengthWords(answer.gap.upper)}`,
      };
    case "undecided":
      return { tone: "unknown", text: "Undecided", aside: "it would take too long to tell" };
    case "no-attractor":
      return { tone: "unknown", text: "No attractor", aside: "the maps do not contract together" };
  }
}
