import { atResolution, STATE } from "#geometry/states";
import type { Connectedness, Verdict } from "#wasm/api";
import * as messages from "./messages";
import { formatNumber } from "./numbers";

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

const raised = (n: number): string => [...String(n)].map((c) => RAISED[c] ?? c).join("");

/** 4.1 × 10⁵; small powers are written out. */
export function powerWords(x: number): string {
  if (!Number.isFinite(x) || x === 0) return formatNumber(x);
  const size = Math.abs(x);
  if (size >= 0.001 && size < 1e5) return formatNumber(x, size < 10 ? 3 - Math.floor(Math.log10(size)) : 0);
  const [mantissa = "", exponent = "0"] = x.toExponential(1).split("e");
  const digits = Number(mantissa) === 1 ? "" : `${String(Number(mantissa)).replace("-", "−")} × `;
  return `${digits}10${raised(Number(exponent))}`;
}

/** How finely it was looked, as a part of the shape's diameter: 1/600. */
export function resolutionWords(epsilon: number): string {
  const whole = Math.round(1 / epsilon);
  if (whole >= 1e6) return powerWords(epsilon);
  return whole < 1e4
    ? `1/${whole}`
    : `1/${Math.floor(whole / 1000)} ${String(whole % 1000).padStart(3, "0")}`;
}

/** Digits beyond these are rounding. */
const SURE = 1 - 1e-9;

/**
 * A gap as a part of the shape's diameter, in per cent with two figures that count, and never less than it is: "0.32%",
 * "3.1 × 10⁻⁷%". Empty where it cannot be told.
 */
export function shareWords(share: number): string {
  const percent = 100 * share;
  if (!Number.isFinite(percent)) return "";
  if (!(percent > 0)) return "0%";
  const power = Math.floor(Math.log10(percent)) - 1;
  const up = Math.ceil((percent / 10 ** power) * SURE);
  if (percent < 1e-4) return `${powerWords(Number(`${up}e${power}`))}%`;
  return `${power < 0 ? Number(`${up}e${power}`) : Math.ceil(percent * SURE)}%`;
}

/** What a picture of 600 pixels resolves, as a part of the diameter: the page judges by it unless it says otherwise. */
export const RESOLUTION = 1 / 600;

/** What a verdict is told from. */
export type Told = Pick<Connectedness, "verdict" | "gap" | "diameter"> & {
  /** Whether a checker has taken a certificate of it. */
  checked?: boolean;
};

export interface VerdictWords {
  /** One of four: a state is never told by colour alone. */
  tone: "whole" | "close" | "broken" | "unknown";
  text: string;
  aside: string;
}

/** What stands behind a gap that no checker has looked at. */
export const OWN_BOUNDS = messages.byFrondsOwnBounds;

/**
 * What is known of a shape, of the plane or of space, in the words of the whole page; null while it is not known. Only
 * a proof is said to be one, and that a shape is in pieces only where a checker has taken the proof. `epsilon` is
 * what it was looked at with.
 */
export function verdictWords(answer: Told | null, epsilon = RESOLUTION): VerdictWords {
  switch (answer?.verdict) {
    case "connected":
      return { tone: "whole", text: messages.inOnePieceProved, aside: "" };
    case "touching":
      return { tone: "close", text: messages.noGapSeen, aside: messages.checkedTo(resolutionWords(epsilon)) };
    case "disconnected": {
      const share = shareOf(answer);
      const hidden = stateOf(answer, epsilon) === STATE.hidden;
      const finer = hidden ? messages.under(resolutionWords(epsilon)) : "";
      const gap = messages.gapIs(shareWords(share), finer);
      return answer.checked
        ? { tone: "broken", text: messages.inPiecesProved, aside: gap }
        : { tone: "broken", text: messages.inPiecesText, aside: `${gap}, ${OWN_BOUNDS}` };
    }
    case "undecided":
      return { tone: "unknown", text: messages.notDecided, aside: messages.decidingWouldTakeToo };
    case "no-attractor":
      return { tone: "unknown", text: messages.noAttractor, aside: messages.mapsDoNotContractTogether };
    default:
      return { tone: "unknown", text: messages.checking, aside: "" };
  }
}

/** The widest gap as a part of the diameter. */
export const shareOf = ({ gap, diameter }: Told): number => gap.upper / diameter;

/** The same as one line. */
export function verdictLine(answer: Told | null, epsilon = RESOLUTION): string {
  return lineOf(verdictWords(answer, epsilon));
}

/** The same within a sentence: "in pieces, gap 3.1%, by Frond’s own bounds". */
export function verdictPhrase(answer: Told | null, epsilon = RESOLUTION): string {
  return phraseOf(verdictWords(answer, epsilon));
}

/** Words as one line. */
export const lineOf = ({ text, aside }: VerdictWords): string => (aside === "" ? text : `${text}, ${aside}`);

/** The same within a sentence. */
export function phraseOf(words: VerdictWords): string {
  const line = lineOf(words);
  return line.charAt(0).toLowerCase() + line.slice(1);
}

const VERDICTS: Record<number, Verdict> = {
  [STATE.connected]: "connected",
  [STATE.touching]: "touching",
  [STATE.disconnected]: "disconnected",
  [STATE.hidden]: "disconnected",
  [STATE.undecided]: "undecided",
  [STATE.none]: "no-attractor",
};

/** The state of a sample of which so much is known. */
export function stateOf(told: Told, epsilon = RESOLUTION): number {
  switch (told.verdict) {
    case "connected":
      return STATE.connected;
    case "touching":
      return STATE.touching;
    case "disconnected":
      return atResolution(STATE.disconnected, shareOf(told), epsilon);
    case "undecided":
      return STATE.undecided;
    case "no-attractor":
      return STATE.none;
  }
}

/**
 * What one sample says, by its state and its relative gap, which has no more than single precision; null where it says
 * nothing.
 */
export function toldOf(state: number, gap: number): Told | null {
  const verdict = VERDICTS[state];
  const upper = Number(gap.toPrecision(6));
  return verdict === undefined ? null : { verdict, gap: { lower: upper, upper }, diameter: 1 };
}
