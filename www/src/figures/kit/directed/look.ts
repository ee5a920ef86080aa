/** Where the states of graph-directed systems lie. */
import type { Box } from "#geometry/boxes";
import type { DirectedIfs } from "#wasm/api";
import { directed } from "#wasm/directed";

/** The boxes of all states, or what is wrong with the system. */
export function look(
  system: DirectedIfs,
): { boxes: Box[]; facts: ReturnType<typeof directed.directedFacts> } | string {
  try {
    const facts = directed.directedFacts(system);
    const boxes = facts.states.map(({ min, max }) => ({ x0: min[0], y0: min[1], x1: max[0], y1: max[1] }));
    return { boxes, facts };
  } catch (problem) {
    return problem instanceof Error ? problem.message : String(problem);
  }
}
