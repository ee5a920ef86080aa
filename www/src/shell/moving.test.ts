import { expect, it } from "vitest";
import { advance } from "#geometry/moment";
import { roundOf } from "./moving";

const FRAME = 1 / 60;

it("is back after it has been at both ends, wherever it began", () => {
  for (const start of [0, 0.3, 0.95, 1]) {
    const isBack = roundOf(start, 1);
    let [t, way, seconds] = [start, start >= 1 ? -1 : 1, 0];
    const seen = [t];
    do {
      const next = advance(t, FRAME, way, { speed: 1, loop: true });
      [t, way] = [next.t, next.way];
      seen.push(t);
      seconds += FRAME;
    } while (!isBack(t) && seconds < 60);
    expect(Math.abs(t - start)).toBeLessThan(0.01);
    expect(Math.min(...seen)).toBeLessThan(0.01);
    expect(Math.max(...seen)).toBeGreaterThan(0.99);
    expect(seconds).toBeCloseTo(16, 0);
  }
});

it("is at the end after one way, where it is to stop there", () => {
  const isThere = roundOf(0, 1, 1);
  const seen = [0.2, 0.5, 0.99, 1, 0.9].map(isThere);
  expect(seen).toEqual([false, false, false, true, true]);
});

it("is back after one turn where the end is the beginning", () => {
  const isBack = roundOf(1, 4);
  let at = 1;
  let turned = 0;
  do {
    at = (at + 0.05) % 4;
    turned += 0.05;
  } while (!isBack(at) && turned < 20);
  expect(turned).toBeCloseTo(4, 1);
});
