/** The evidence for a verdict in plain words. */

import { countWords, lengthWords, resolutionWords, shareOf, shareWords, stateOf } from "#format/verdict";
import { STATE } from "#geometry/states";
import type { CertificateCheck, Connectedness, Link } from "#wasm/api";
import * as messages from "./messages";

/** How far the verdict can be relied on, and why. Only a proof is said to be one. */
export function accountOf(answer: Connectedness, epsilon: number): string {
  const fine = resolutionWords(epsilon);
  switch (answer.verdict) {
    case "connected": {
      const how = answer.reason ? "" : messages.proofOneUsedFor;
      return messages.onePiece(how);
    }
    case "touching":
      return messages.touching(fine);
    case "disconnected": {
      const hidden = stateOf(answer, epsilon) === STATE.hidden ? messages.narrowGap(fine) : "";
      return messages.inPieces(hidden);
    }
    case "undecided":
      return messages.undecided(countWords(answer.nodes));
    case "no-attractor":
      return messages.togetherTheseMapsDo;
  }
}

/** The widest gap in per cent of the diameter, and in the unit of the plane; null where there is nothing to measure. */
export function gapWords(answer: Connectedness): string | null {
  const { verdict, gap } = answer;
  if (verdict === "connected" || verdict === "no-attractor" || !Number.isFinite(gap.upper)) return null;
  const share = shareWords(shareOf(answer));
  const part = share === "" ? "" : messages.shareOf(share);
  const unit = messages.inUnitsPlane;
  if (verdict === "disconnected") {
    const [low, high] = apart(gap.lower, gap.upper);
    return low === high ? messages.exactly(part, high, unit) : messages.between(part, low, high, unit);
  }
  return messages.atMost(part, lengthWords(gap.upper), unit);
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

/** Numbers from 1, runs of four or more as "4 to 9". */
function numbersWords(maps: readonly number[]): string {
  const sorted = [...maps].sort((p, q) => p - q);
  const spans: string[] = [];
  for (let i = 0; i < sorted.length; ) {
    let end = i;
    while (sorted[end + 1] === (sorted[end] ?? 0) + 1) end++;
    const [from, to] = [(sorted[i] ?? 0) + 1, (sorted[end] ?? 0) + 1];
    if (end - i >= 3) spans.push(messages.range(from, to));
    else for (let n = from; n <= to; n++) spans.push(String(n));
    i = end + 1;
  }
  return spans.join(",");
}

/** Which pieces hang together: "{1,3} | {2}", the largest cluster first. */
export function clusterWords(components: readonly number[]): string {
  const clusters = new Map<number, number[]>();
  components.forEach((cluster, map) => {
    clusters.set(cluster, [...(clusters.get(cluster) ?? []), map]);
  });
  const sorted = [...clusters.values()].sort((p, q) => q.length - p.length);
  return sorted.map((cluster) => `{${numbersWords(cluster)}}`).join(" | ");
}

/** What holds two pieces together, as a sentence. */
export function linkWords({ kind, pair: [i, j], words, at }: Link): string {
  const pieces = messages.piecePair(i + 1, j + 1);
  if (kind === "crossing") return messages.cross(pieces, words[0], words[1]);
  if (kind === "difference") return messages.difference(pieces);
  if (kind === "line") return messages.overlapOnLine(pieces);
  if (kind === "area") return messages.area(pieces);
  // Rounding leaves a trace where a number is 0.
  const place = at.map((x) => lengthWords(Math.abs(x) < 1e-12 ? 0 : x).replace("-", "−")).join(", ");
  return messages.sharePoint(pieces, place, words[0], words[1]);
}

/**
 * How an address is read: "1(2)" is 1222.., each letter a piece of the one before. Of more than nine maps letters are
 * joined by dots, and one stands before the bracket: "12.3.(10)".
 */
export function addressWords(address: string): string {
  const [, first = "", cycle = ""] = /^([\d.]*)\(([\d.]*)\)$/.exec(address) ?? [];
  const dot = address.includes(".") ? "." : "";
  const letters = (part: string) => part.split(dot).filter((letter) => letter !== "");
  const head = letters(first);
  const again = letters(cycle);
  if (again.length === 0) return "";
  const written: string[] = [...head];
  while (written.length < Math.max(5, head.length + 2)) {
    written.push(again[(written.length - head.length) % again.length] ?? "");
  }
  return messages.addressShort(address, written.join(dot));
}

/** What the checker said. */
export function checkWords(check: CertificateCheck): string {
  if (!check.valid) return messages.checkFailed(check.text);
  if (check.links > 0) {
    const links = messages.contacts(check.links);
    return messages.contactsVerified(links, lettersOf(check));
  }
  const pairs = messages.pairs(check.pairs);
  return messages.pairsVerified(pairs, lettersOf(check));
}

function lettersOf({ longest }: CertificateCheck): string {
  return messages.levels(longest);
}
