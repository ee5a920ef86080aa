/** The seven maps of Table 3 as graphs, and how far they are from what they were found for. */
import type { Graph } from "../engine/api";
import { heightsAlong, TOP } from "./arrowhead";
import { graphOf } from "./graphs";
import { TABLE_3, TABLE_3_EXACT } from "./printed";

/** The maps with the fractions that the table rounds: with three digits they leave holes. */
export const TABLE_3_GRAPH: Graph = graphOf("pfif", TABLE_3_EXACT);

/** The maps with the heights as printed, and the fractions for t, so that their pieces join. */
export const TABLE_3_PRINTED: Graph = graphOf(
  "pfif",
  TABLE_3_EXACT.map(({ map: [a, , , d], domain }, i) => {
    const [, b, c, , e] = TABLE_3[i]?.map ?? [0, 0, 0, 0, 0];
    return { map: [a, b, c, d, e], domain };
  }),
);

/** The function of Figure 4 at so many even steps of t as its last level has. */
export const DEPTH = 7;

export interface Misses {
  worst: number;
  meanSquare: number;
  /** Where the worst one is. */
  at: number;
}

/** How far a function is from that of Figure 4, at the 2187 steps of its seventh level. */
export function missesOf(at: (t: number) => number): Misses {
  const known = heightsAlong(DEPTH, TOP);
  const misses: Misses = { worst: 0, meanSquare: 0, at: 0 };
  const count = known.length / 2;
  for (let i = 0; i < count; i++) {
    const t = known[2 * i] ?? 0;
    const miss = Math.abs(at(t) - (known[2 * i + 1] ?? 0));
    misses.meanSquare += miss ** 2 / count;
    if (miss > misses.worst) [misses.worst, misses.at] = [miss, t];
  }
  return misses;
}
