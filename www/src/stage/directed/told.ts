/** What is said of the states of a graph-directed shape. */
import type { Told } from "#format/verdict";
import type { DirectedCertificate } from "#wasm/api";
import type { Moment, Way } from "#workers/directed/moment";

/**
 * What is known of each state at a moment, or more where all of its way is proved. On the way states are those of the
 * matched graphs, at its ends those of the shape, of which only the first is sure to be the same.
 */
export function toldOf(
  states: readonly Told[],
  { from, to, mode, t }: Moment,
  way: Way,
  proof: DirectedCertificate | null,
): readonly Told[] {
  // What a proof assumes of numbers is not so for the numbers as they are.
  if (!proof || proof.assuming.length > 0) return states;
  if (from !== way.from || to !== way.to || mode !== way.mode) return states;
  const between = t > 0 && t < 1;
  return states.map((state, k) => {
    const always = (k === 0 || between) && proof.states[k]?.kind === "connected";
    return always ? { ...state, verdict: "connected" } : state;
  });
}
