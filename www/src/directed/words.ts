/** What is said of graph-directed shapes. */
import { percent } from "#format/path-words";
import { OWN_BOUNDS, resolutionWords } from "#format/verdict";
import type { DirectedCertificate, DirectedIfs } from "#wasm/api";

/** How much a shape is made of: "2 states, 7 maps". A system of maps has one state, of which nothing is said. */
export function sizeWords({ states }: DirectedIfs): string {
  const maps = states.reduce((sum, state) => sum + state.length, 0);
  const words = `${maps} ${maps === 1 ? "map" : "maps"}`;
  return states.length === 1 ? words : `${states.length} states, ${words}`;
}

/** The same as short as a card has room for. */
export function stateWords({ states }: DirectedIfs): string {
  return states.length === 1 ? "1 state" : `${states.length} states`;
}

interface WayKnown {
  proof: DirectedCertificate | null;
  /** The first moment that is known to be in pieces. */
  apart: number | null;
  /** No proof is looked for any more. */
  ended: boolean;
}

/** What is known of every moment of a way, in words. */
export function wayWords({ proof, apart, ended }: WayKnown): string {
  const first = proof?.states[0];
  if (first?.kind === "connected") {
    const assuming = proof && proof.assuming.length > 0 ? `, if ${proof.assuming[0]} and so on` : "";
    return `The shape is in one piece at every moment of the way, proved${assuming}: its pieces share points that never part.`;
  }
  if (first?.kind === "within") {
    return `At every moment of the way its pieces, and theirs, are held together by gaps of at most ${resolutionWords(first.gap)} of their size. This was found at ${proof?.moments} moments, with bounds of what changes between them.`;
  }
  if (apart !== null)
    return `It falls apart on this way: at ${percent(apart)} it is in pieces, ${OWN_BOUNDS}.`;
  if (first?.kind === "open") {
    return `There is no proof that it stays in one piece all the way: what was looked for is lost at ${percent(first.at)}.`;
  }
  return ended
    ? "No proof about every moment of the way was found in the time that there is for it."
    : "Looking for a proof about every moment of the way …";
}
