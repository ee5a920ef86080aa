import { expect, it } from "vitest";
import { play } from "../lesson-15/dice";
import { fewestFor, LEAF, MOST_DIGITS, NEAR, promise, REACH, rounded } from "./rounded";

it("keeps the leaf within its reach", () => {
  const { points } = play([...LEAF], [1, 1, 1, 1], 20_000);
  for (let i = 0; i < points.length; i += 2)
    expect(Math.hypot(points[i] ?? 0, points[i + 1] ?? 0)).toBeLessThan(REACH);
});

it("promises more with every digit, and nothing is lost without rounding", () => {
  expect(promise(LEAF, LEAF)).toBe(0);
  let before = Number.POSITIVE_INFINITY;
  for (let digits = 1; digits <= MOST_DIGITS; digits++) {
    const now = promise(LEAF, rounded(LEAF, digits));
    expect(now).toBeLessThan(before);
    before = now;
  }
});

it("keeps what it promises, address by address", () => {
  for (const digits of [1, 2, 3]) {
    const others = rounded(LEAF, digits);
    const most = promise(LEAF, others);
    // The same throws for both: points with the same address.
    const [exact, coarse] = [LEAF, others].map((maps) => play([...maps], [1, 1, 1, 1], 4000).points);
    let far = 0;
    for (let i = 200; i < (exact?.length ?? 0); i += 2)
      far = Math.max(
        far,
        Math.hypot((exact?.[i] ?? 0) - (coarse?.[i] ?? 0), (exact?.[i + 1] ?? 0) - (coarse?.[i + 1] ?? 0)),
      );
    expect(far).toBeGreaterThan(0);
    expect(far).toBeLessThan(most);
  }
});

it("promises what teachers are told", () => {
  const at = (digits: number) => promise(LEAF, rounded(LEAF, digits));
  expect(at(3)).toBeLessThan(0.0017);
  expect(at(3)).toBeGreaterThan(0.0016);
  expect(at(2)).toBeLessThan(0.036);
  expect(at(2)).toBeGreaterThan(0.035);
});

it("finds the fewest digits", () => {
  const digits = fewestFor(NEAR);
  expect(promise(LEAF, rounded(LEAF, digits))).toBeLessThanOrEqual(NEAR);
  expect(promise(LEAF, rounded(LEAF, digits - 1))).toBeGreaterThan(NEAR);
});
