import { expect, test } from "vitest";
import { bandsOf } from "./bands";

test("bands are all rows, once, whole pixels, and about alike", () => {
  for (const [height, factor, count] of [
    [600, 1, 2],
    [601, 2, 2],
    [7, 2, 3],
    [1, 2, 2],
  ] as const) {
    const bands = bandsOf(height, factor, count);
    expect(bands.length).toBe(Math.min(count, height));
    expect(bands[0]?.[0]).toBe(0);
    expect(bands.at(-1)?.[1]).toBe(height * factor);
    for (const [i, [from, to]] of bands.entries()) {
      expect(to - from).toBeGreaterThan(0);
      expect((to - from) % factor).toBe(0);
      expect(Math.abs((to - from) / factor - height / bands.length)).toBeLessThanOrEqual(1);
      if (i > 0) expect(from).toBe(bands[i - 1]?.[1]);
    }
  }
});
