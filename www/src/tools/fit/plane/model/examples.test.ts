import { expect, test } from "vitest";
import { EXAMPLES } from "./examples";

/** Words for lengths, as the notes write them. */
const LENGTHS: Readonly<Record<string, number>> = { "a third": 1 / 3, half: 1 / 2, "1/√2": Math.SQRT1_2 };
const COUNTS: Readonly<Record<string, number>> = { Two: 2, Three: 3, Four: 4 };

test("notes name how long the copies are", () => {
  let named = 0;
  for (const { id, about, make } of EXAMPLES) {
    expect(about, id).not.toMatch(/halves|thirds|quarters|of half the size/);
    const [, count = "", length = ""] = /^(\w+) copies, each (.+?) as long/.exec(about) ?? [];
    if (!length) continue;
    named++;
    const { points } = make();
    const apart = (i: number, k: number) =>
      Math.hypot(
        (points[i]?.[1] ?? 0) - (points[k]?.[1] ?? 0),
        (points[i]?.[2] ?? 0) - (points[k]?.[2] ?? 0),
      );
    const whole = apart(0, points.length - 1);
    expect(points.length - 1, id).toBe(COUNTS[count]);
    for (let i = 0; i + 1 < points.length; i++)
      expect(apart(i, i + 1) / whole, `${id}, ${i}`).toBeCloseTo(LENGTHS[length] ?? Number.NaN, 12);
  }
  expect(named).toBe(3);
});

test("the dragon turns by 45 degrees to either side", () => {
  const { points } = EXAMPLES.find(({ id }) => id === "dragon")?.make() ?? { points: [] };
  const degrees = [0, 1].map((i) => {
    const [, x = 0, y = 0] = points[i] ?? [];
    const [, nextX = 0, nextY = 0] = points[i + 1] ?? [];
    return (Math.atan2(nextY - y, nextX - x) * 180) / Math.PI;
  });
  expect(degrees[0]).toBeCloseTo(45, 9);
  expect(degrees[1]).toBeCloseTo(-45, 9);
});
