/** What is said of closed curves. */
import type { Curve } from "#wasm/api";
import * as messages from "./messages";

/** How much a curve is made of. */
export function sizeWords({ knots, edges }: Curve): string {
  const copies = edges.filter((edge) => edge !== null).length;
  const about = `${knots.length} ${knots.length === 1 ? "knot" : "knots"}`;
  return copies === 0 ? about : `${about}, ${copies} ${copies === 1 ? "copy" : "copies"}`;
}

/** How often a curve crosses itself; nothing where it does not. */
export function crossingWords(crossings: number): string {
  if (crossings <= 0) return "";
  if (crossings === 1) return messages.crossesItselfOnce;
  return crossings === 2 ? messages.crossesItselfTwice : messages.crossesTimes(crossings);
}

/** Why it is in one piece, in a sentence or two. */
export function whyWords(ends: { a: string; b: string } | null): string {
  const edges = messages.everyEdgeStraightOr;
  const between = ends ? messages.alsoBetween(ends.a, ends.b) : "";
  return messages.nowhereApart(edges, between);
}

/** What is true of the whole way, given how often the curve crosses itself where it does so most. */
export function wayWords(worst: number): string {
  return worst > 0 ? messages.crossesMost(crossingWords(worst)) : messages.outlineMadeSmallerCopies;
}

/** Where too few knots have a partner for the way to look like one leaf that changes: what helps. */
export function unlikeWords(a: number, b: number, both: number, worst: number): string | null {
  const met = a + b - both;
  if (worst === 0 || met > Math.min(a, b) / 4) return null;
  return messages.soFewKnotsHave;
}

/** How the knots of two curves were brought together, given how many there are in common. */
export function matchWords(a: number, b: number, both: number): string {
  const met = a + b - both;
  if (met <= 0) return messages.knotsBetween(both);
  const [alone, others] = [a - met, b - met];
  const rest = alone + others === 0 ? messages.everyKnotHasPartner : messages.otherKnots(alone + others);
  return messages.knotsMet(met, rest);
}
