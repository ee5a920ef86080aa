import { describe, expect, it } from "vitest";
import { Bisection, median } from "./bisection";

describe("Bisection", () => {
  it("closes in on the turn, in as many answers as it said", () => {
    const turn = 0.4942;
    const search = new Bisection(0.45, 0.53, 1e-4);
    while (!search.done) search.tell(search.middle, search.middle >= turn);
    expect(search.low).toBeLessThan(turn);
    expect(search.high).toBeGreaterThanOrEqual(turn);
    expect(search.high - search.low).toBeLessThanOrEqual(1e-4);
    expect(search.asked).toBe(Bisection.answers(0.45, 0.53, 1e-4));
  });
  it("ends at an end where the answer is always the same", () => {
    const never = new Bisection(0, 1, 0.01);
    while (!never.done) never.tell(never.middle, false);
    expect(never.high).toBe(1);
  });
  it("has nothing to ask about an interval that is narrow already", () => {
    expect(new Bisection(0, 0.1, 0.1).done).toBe(true);
    expect(Bisection.answers(0, 0.1, 0.1)).toBe(0);
  });
});

describe("median", () => {
  it("takes the middle, in whatever order", () => {
    expect(median([3, 1, 2])).toBe(2);
    expect(median([4, 1, 3, 2])).toBe(2);
    expect(median([])).toBeNaN();
  });
});
