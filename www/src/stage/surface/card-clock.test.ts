import { describe, expect, it } from "vitest";
import { CardClock } from "./card-clock";

/** After so many frames of this length and so many points each: when it was late. */
function measured(frames: number, milliseconds: number, points = 2_000_000): [CardClock, number[]] {
  const clock = new CardClock();
  const late = Array.from({ length: frames }, (_, i) => (clock.isLate(milliseconds, points) ? [i] : []));
  return [clock, late.flat()];
}

describe("a card is measured by its frames", () => {
  it("stays where its frames come in time and are full of points", () => {
    expect(measured(500, 17)[1]).toEqual([]);
  });

  it("is late once after a dozen slow frames, and not for one of them", () => {
    expect(measured(40, 60)[1]).toEqual([11]);
    const clock = new CardClock();
    const lengths = Array.from({ length: 60 }, (_, i) => (i % 4 === 0 ? 90 : 16));
    expect(lengths.some((length) => clock.isLate(length, 2_000_000))).toBe(false);
  });

  it("is late again after some hundred frames: the processor may have had other things to do", () => {
    const [, late] = measured(1000, 60);
    expect(late[0]).toBe(11);
    expect(late).toHaveLength(2);
    expect(late[1]).toBeGreaterThan(500);
  });

  it("is late where its frames come in time with few points", () => {
    expect(measured(20, 17, 20_000)[1]).toEqual([11]);
  });

  it("gives way to a processor whose frames come clearly sooner", () => {
    const [clock] = measured(12, 60);
    expect(clock.isSlowerThan(12)).toBe(true);
    expect(clock.isSlowerThan(55)).toBe(false);
    expect(clock.isSlowerThan(Number.POSITIVE_INFINITY)).toBe(false);
  });

  it("gives way to a processor that is in time where its own pictures are coarse", () => {
    const [clock] = measured(12, 17, 20_000);
    expect(clock.isSlowerThan(14)).toBe(true);
    expect(clock.isSlowerThan(30)).toBe(false);
  });

  it("lets the processor try some times, and all anew after a change of size", () => {
    const [clock] = measured(12, 60);
    expect(Array.from({ length: 5 }, () => clock.takeTry())).toEqual([true, true, true, false, false]);
    expect(clock.isLate(60, 0)).toBe(false);
    clock.reset();
    expect(Array.from({ length: 12 }, () => clock.isLate(60, 1e6)).indexOf(true)).toBe(11);
  });
});
