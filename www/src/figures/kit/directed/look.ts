/** What graph-directed systems look like: where their states lie, and what they are made of. */
import type { Box } from "#geometry/boxes";
import type { DirectedIfs, DirectedMap } from "#wasm/api";
import { directed } from "#wasm/directed";

/** What a state is made of, in words: "3 copies of state 2". */
export function madeOf(maps: readonly DirectedMap[]): string {
  const counts = new Map<number, number>();
  for (const { from } of maps) counts.set(from, (counts.get(from) ?? 0) + 1);
  return [...counts]
    .sort(([p], [q]) => p - q)
    .map(([from, count]) => `${count === 1 ? "1 copy" : `${count} copies`} of state ${from + 1}`)
    .join(", ");
}

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
