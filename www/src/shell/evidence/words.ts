/** The evidence for a verdict in plain words. */
import type { CertificateCheck, Connectedness, Link } from "../../engine/api";
import { countWords, lengthWords, verdictWords } from "../../state/words";

export interface Account {
  /** What holds, as a sentence. */
  title: string;
  /** How far that can be relied on, and why. */
  why: string;
}

/** What is known, and how surely. Only a proof is said to be one. */
export function accountOf(answer: Connectedness): Account {
  switch (answer.verdict) {
    case "connected":
      return {
        title: "It is in one piece.",
        why: "That is proved: from each of its pieces every other can be reached without a leap, at any magnification.",
      };
    case "touching":
      return {
        title: "No gap can be seen.",
        why: "Its pieces come within 1/600 of its size of each other, so a picture of 600 pixels shows one piece. Whether they truly meet is not proved.",
      };
    case "disconnected":
      if (verdictWords(answer).tone === "close")
        return {
          title: "No gap can be seen, but there is one.",
          why: `It is proved to be in at least ${piecesWords(answer.count)}. They lie nearer to each other than 600 pixels can show.`,
        };
      return {
        // Each of its pieces falls apart the same way: the groups of the largest ones are only the first to be seen.
        title: `It is in at least ${piecesWords(answer.count)}.`,
        why: "That is proved: no matter how closely one looks, nothing bridges the gap between them.",
      };
    case "undecided":
      return {
        title: "It could not be decided.",
        why: `After ${countWords(answer.nodes)} pairs of pieces Frond has neither found a gap nor come close enough to call them touching.`,
      };
    case "no-attractor":
      return {
        title: "There is no shape here.",
        why: "Together these maps do not contract: points wander off, and never settle on a shape that could be in one piece or several.",
      };
  }
}

function piecesWords(count: number): string {
  const small = ["no pieces", "one piece", "two pieces", "three pieces", "four pieces", "five pieces"];
  return small[count] ?? `${count} pieces`;
}

/** The widest gap as a length; null where there is nothing to measure. */
export function gapWords({ verdict, gap, diameter }: Connectedness): string | null {
  if (verdict === "connected" || verdict === "no-attractor" || !Number.isFinite(gap.upper)) return null;
  const share = shareWords(gap.upper / diameter);
  const of = share === "" ? "" : `, ${share} of its size`;
  if (verdict === "disconnected") {
    const [low, high] = apart(gap.lower, gap.upper);
    return low === high ? `${high}${of}` : `between ${low} and ${high}${of}`;
  }
  return `at most ${lengthWords(gap.upper)}${of}`;
}

/** Two bounds with as many digits as it takes to tell them apart, five at most. */
function apart(lower: number, upper: number): [string, string] {
  for (let digits = 2; digits <= 5; digits++) {
    const [low, high] = [lower, upper].map((x) => plain(x, digits)) as [string, string];
    if (low !== high) return [low, high];
  }
  const both = plain(upper, 5);
  return [both, both];
}

function plain(x: number, digits: number): string {
  if (x === 0) return "0";
  const size = Math.abs(x);
  if (size < 1e-4 || size >= 1e5) return x.toExponential(digits - 1).replace("-", "−");
  return x.toPrecision(digits).includes("e") ? x.toFixed(0) : x.toPrecision(digits);
}

/** A part of the whole in hundredths: "1.2%", "0.031%"; empty where it cannot be told. */
export function shareWords(share: number): string {
  if (!Number.isFinite(share) || share < 0) return "";
  const hundredths = 100 * share;
  if (hundredths === 0) return "0%";
  if (hundredths < 1e-3) return "less than 0.001%";
  return `${hundredths >= 10 ? hundredths.toFixed(0) : Number(hundredths.toPrecision(2))}%`;
}

/** Numbers from 1, runs of three or more as "4 to 9". */
export function numbersWords(maps: readonly number[]): string {
  const sorted = [...maps].sort((p, q) => p - q);
  const spans: string[] = [];
  for (let i = 0; i < sorted.length; ) {
    let end = i;
    while (sorted[end + 1] === (sorted[end] ?? 0) + 1) end++;
    const [from, to] = [(sorted[i] ?? 0) + 1, (sorted[end] ?? 0) + 1];
    if (end - i >= 2) spans.push(`${from} to ${to}`);
    else for (let n = from; n <= to; n++) spans.push(String(n));
    i = end + 1;
  }
  return spans.length < 2 ? spans.join("") : `${spans.slice(0, -1).join(", ")} and ${spans.at(-1) ?? ""}`;
}

/** Which maps belong together, each group as a sentence, the largest first. */
export function groupWords(components: readonly number[]): string[] {
  const groups = new Map<number, number[]>();
  components.forEach((group, map) => {
    groups.set(group, [...(groups.get(group) ?? []), map]);
  });
  const sorted = [...groups.values()].sort((p, q) => q.length - p.length);
  if (sorted.length === 1) {
    const [all] = sorted;
    const count = all?.length ?? 0;
    if (count === 1) return ["There is a single piece."];
    return [count === 2 ? "Both pieces hang together." : `All ${count} pieces hang together.`];
  }
  const alone = sorted.filter((group) => group.length === 1).flat();
  const words = sorted
    .filter((group) => group.length > 1)
    .map((group) => `Pieces ${numbersWords(group)} hang together.`);
  if (alone.length === 1) words.push(`Piece ${numbersWords(alone)} stands alone.`);
  else if (alone.length > 1) words.push(`Pieces ${numbersWords(alone)} stand alone, each by itself.`);
  return words;
}

/** What holds two pieces together, as a sentence. */
export function linkWords({ kind, pair: [i, j], words, at }: Link): string {
  const pieces = `Pieces ${i + 1} and ${j + 1}`;
  if (kind === "crossing")
    return `${pieces} cross: a path through copy ${words[0]} has to meet one through copy ${words[1]}.`;
  if (kind === "area") return `${pieces} are too large to leave room between them.`;
  // Rounding leaves a trace where a number is 0.
  const place = at.map((x) => lengthWords(Math.abs(x) < 1e-12 ? 0 : x).replace("-", "−")).join(", ");
  return `${pieces} share the point (${place}), address ${words[0]} = ${words[1]}.`;
}

/** How an address is read: "1(2)" is 1222.., each letter a piece of the one before. */
export function addressWords(address: string): string {
  const [, first = "", cycle = ""] = /^([\d ,.]*)\(([^)]*)\)/.exec(address) ?? [];
  if (cycle === "") return "";
  const written = /^\d*$/.test(first + cycle)
    ? `${(first + cycle.repeat(4)).slice(0, Math.max(5, first.length + 2))}…`
    : "";
  const meaning = "each letter is a piece within the one before";
  return written === ""
    ? `In an address ${meaning}; what is in brackets goes on for ever.`
    : `${address} is short for ${written}: ${meaning}.`;
}

/** What the checker said. */
export function checkWords(check: CertificateCheck): string {
  if (!check.valid) return `The check failed: ${check.text}`;
  const pairs = check.pairs === 1 ? "1 pair" : `${check.pairs.toLocaleString("en")} pairs`;
  const letters = check.longest === 1 ? "one letter" : `up to ${check.longest} letters`;
  return `Checked in exact arithmetic: ${pairs} of pieces, words of ${letters}.`;
}
