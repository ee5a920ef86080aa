import type { Intersection3 } from "#wasm/api";
import { MeetGraph } from "./product-graph";

/** Ways from a shift to another by these pairs of maps. */
const ways = (from: number, to: number, pairs: readonly (readonly [first: number, second: number])[]) =>
  pairs.map(([first, second]) => ({ from, first, second, to }));
const FOUR = [0, 1, 2, 3] as const;

/** The product of a bar and a dust on one line, as its page has it: nothing needs to be fetched for it. */
const PRODUCT: Pick<Intersection3, "shifts" | "arrows"> = {
  shifts: [
    [0, 0, 0],
    [0, -1, 0],
    [0, 1, 0],
    [1, -1, 0],
    [-1, -1, 0],
  ],
  arrows: [
    ...ways(0, 1, [[7, 7]]),
    ...ways(0, 2, [[8, 8]]),
    ...ways(
      1,
      1,
      [0, 1, 2, 3, 4].map((k) => [k, k]),
    ),
    ...ways(
      1,
      3,
      FOUR.map((k) => [k, k + 1]),
    ),
    ...ways(
      1,
      4,
      FOUR.map((k) => [k + 1, k]),
    ),
    ...ways(2, 2, [
      [5, 5],
      [6, 6],
    ]),
    ...ways(3, 3, [[4, 0]]),
    ...ways(4, 4, [[0, 4]]),
  ],
};

export function Thumb() {
  return <MeetGraph found={PRODUCT} />;
}
