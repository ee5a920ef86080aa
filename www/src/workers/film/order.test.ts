import { expect, it } from "vitest";
import { inOrder } from "./order";

const later = (ms: number) => new Promise((resolve) => setTimeout(resolve, ms));

it("takes in order what ends in any order, and never has more under way than it may", async () => {
  const taken: number[] = [];
  let open = 0;
  let most = 0;
  await inOrder(
    9,
    3,
    async (i) => {
      open++;
      most = Math.max(most, open);
      await later(i % 3 === 0 ? 12 : 1);
      return 10 * i;
    },
    async (i, result) => {
      open--;
      expect(result).toBe(10 * i);
      taken.push(i);
    },
  );
  expect(taken).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8]);
  expect(most).toBe(3);
});

it("ends with the first that fails, in its turn", async () => {
  const taken: number[] = [];
  const work = inOrder(
    6,
    4,
    async (i) => {
      if (i === 2) throw new Error("no");
      return i;
    },
    async (i) => {
      taken.push(i);
    },
  );
  await expect(work).rejects.toThrow("no");
  expect(taken).toEqual([0, 1]);
});
