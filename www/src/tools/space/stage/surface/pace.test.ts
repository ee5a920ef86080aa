import { describe, expect, it } from "vitest";
import { Pace, SHRINKS } from "./pace";

/** What a frame takes on a machine that draws a whole picture in so many milliseconds. */
const on = (whole: number) => (shrink: number) => 2 + whole / shrink ** 2;

function paced(frames: number, took: (shrink: number) => number, pace = new Pace()): Pace {
  for (let i = 0; i < frames; i++) pace.frame(took(pace.shrink));
  return pace;
}

describe("the pace of a movement", () => {
  it("has as many pixels as come in time, on any machine", () => {
    for (const whole of [20, 60, 200, 700, 2000]) {
      const { shrink } = paced(300, on(whole));
      expect(on(whole)(shrink), `${whole} ms`).toBeLessThanOrEqual(40);
      const finer = SHRINKS[SHRINKS.indexOf(shrink as 1) - 1];
      if (finer !== undefined) expect(on(whole)(finer), `${whole} ms`).toBeGreaterThan(28);
    }
  });

  it("gives way at once where frames are much too late, and comes back slowly", () => {
    const pace = new Pace();
    const first = pace.shrink;
    pace.frame(330);
    expect(pace.shrink).toBeGreaterThanOrEqual(2.5 * first);
    const slow = pace.shrink;
    pace.frame(1);
    expect(pace.shrink).toBe(slow);
    expect(paced(300, on(5), pace).shrink).toBe(1);
  });

  it("rests where it is right", () => {
    const pace = paced(300, on(250));
    const { shrink } = pace;
    for (let i = 0; i < 100; i++) {
      pace.frame(on(250)(pace.shrink));
      expect(pace.shrink).toBe(shrink);
    }
  });

  it("does not heed frames of another size, nor what is no time", () => {
    const pace = new Pace();
    const { shrink } = pace;
    pace.frame(500, shrink + 1);
    pace.frame(Number.NaN);
    expect(pace.shrink).toBe(shrink);
  });

  it("has a coarsest picture", () => {
    expect(paced(50, () => 1000).shrink).toBe(SHRINKS.at(-1));
    const small = new Pace();
    small.stage(600 * 400);
    // 190 x 126 pixels are nearly as few as there may be.
    expect(paced(50, () => 1000, small).shrink).toBe(3);
    small.stage(100 * 100);
    expect(small.shrink).toBe(1);
  });
});
