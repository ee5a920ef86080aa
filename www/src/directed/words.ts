/** What is said of graph-directed shapes. */
import { percent } from "#format/path-words";
import { OWN_BOUNDS, resolutionWords } from "#format/verdict";
import type { DirectedCertificate, DirectedIfs } from "#wasm/api";
import * as messages from "./messages";

/** How much a shape is made of: "2 states, 7 maps". A system of maps has one state, of which nothing is said. */
export function sizeWords({ states }: DirectedIfs): string {
  const maps = states.reduce((sum, state) => sum + state.length, 0);
  const words = `${maps} ${maps === 1 ? "map" : "maps"}`;
  return states.length === 1 ? words : messages.statesAnd(states.length, words);
}

/** The same as short as a card has room for. */
export function stateWords({ states }: DirectedIfs): string {
  return states.length === 1 ? "1 state" : messages.stateCount(states.length);
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
    const assuming = proof && proof.assuming.length > 0 ? messages.assuming(proof.assuming[0] ?? "") : "";
    return messages.provedThroughout(assuming);
  }
  if (first?.kind === "within") {
    return messages.gapsAtMost(resolutionWords(first.gap), proof?.moments ?? 0);
  }
  if (apart !== null) return messages.fallsApart(percent(apart), OWN_BOUNDS);
  if (first?.kind === "open") {
    return messages.noProofPast(percent(first.at));
  }
  return ended ? messages.frondFoundNoProof : messages.searchingForProofFor;
}
