import { describe, expect, it } from "vitest";
import { evenly } from "./FilmStrip";

describe("evenly", () => {
  it("keeps both ends", () => {
    const thirteen = Array.from({ length: 13 }, (_, i) => i);
    expect(evenly(thirteen, 7)).toEqual([0, 2, 4, 6, 8, 10, 12]);
    expect(evenly(thirteen, 2)).toEqual([0, 12]);
    expect(evenly(thirteen, 1)).toEqual([0]);
  });
  it("gives all there is where that is fewer", () => {
    expect(evenly([1, 2], 7)).toEqual([1, 2]);
    expect(evenly([], 7)).toEqual([]);
  });
});
