import { expect, test } from "vitest";
import { stalkOf } from "./stalk";

/** A leaf of pointed lobes about the origin, one of them down; between them, below, a stalk if there is one. */
function leaf({ stalk = 0, width = 0.06, lobes = 5 }): Float64Array {
  const points: number[] = [];
  const half = Math.asin(width / 2 / 0.5);
  for (let k = 0; k < 720; k++) {
    const angle = -Math.PI / 2 + half + ((2 * Math.PI - 2 * half) * k) / 719;
    const radius = 0.75 - 0.25 * Math.cos(lobes * (angle + Math.PI / 2)) + 0.02 * (k % 2);
    points.push(radius * Math.cos(angle), radius * Math.sin(angle));
  }
  if (stalk > 0) points.push(-width / 2, -0.5 - stalk, width / 2, -0.5 - stalk);
  return new Float64Array(points);
}

test("a stalk is found, as long as it is", () => {
  const size = Math.hypot(2, 2);
  for (const stalk of [0.5, 0.9]) {
    expect(stalkOf(leaf({ stalk }))).toBeGreaterThan((0.7 * stalk) / size);
    expect(stalkOf(leaf({ stalk }))).toBeLessThan((1.3 * stalk) / size);
  }
  const turned = leaf({ stalk: 0.8 }).reverse();
  expect(stalkOf(turned)).toBeGreaterThan(0.15);
});

test("lobes, teeth and short or broad parts are none", () => {
  for (const lobes of [3, 5, 9]) expect(stalkOf(leaf({ lobes }))).toBe(0);
  expect(stalkOf(leaf({ stalk: 0.1 }))).toBe(0);
  expect(stalkOf(leaf({ stalk: 0.8, width: 0.35 }))).toBe(0);
});

test("outlines without size or points have none", () => {
  for (const points of [[], [1, 1], [1, 1, 1, 1, 1, 1], [0, 0, Number.NaN, 1, 1, 0], [0, 0, 1, 0]])
    expect(stalkOf(points)).toBeLessThanOrEqual(0.5);
});
