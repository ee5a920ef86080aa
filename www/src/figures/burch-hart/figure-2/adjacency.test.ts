import { expect, it } from "vitest";
import { adjacency, ways } from "./adjacency";

it("a graph is its matrix, the same from both sides", () => {
  expect(adjacency(3, [[0, 2]])).toEqual([
    [1, 0, 1],
    [0, 1, 0],
    [1, 0, 1],
  ]);
});

it("the sum of powers has a 0 exactly where no way leads", () => {
  const chain = ways(
    adjacency(4, [
      [0, 1],
      [1, 2],
      [2, 3],
    ]),
  );
  expect(chain[0]).toEqual([7, 8, 4, 1]);
  const parted = ways(
    adjacency(4, [
      [0, 1],
      [2, 3],
    ]),
  );
  expect(parted.map((row) => row.map((value) => value > 0))).toEqual([
    [true, true, false, false],
    [true, true, false, false],
    [false, false, true, true],
    [false, false, true, true],
  ]);
  // Two pieces: the sum is X alone.
  expect(ways(adjacency(2, []))).toEqual(adjacency(2, []));
});
