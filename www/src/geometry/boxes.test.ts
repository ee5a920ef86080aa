import { describe, expect, it } from "vitest";
import { type Box, blendTracks, boxAt, calmTrack, diagonal, sameTrack, stillTrack } from "./boxes";

const square = (size: number, x = 0): Box => ({ x0: x - size, y0: -size, x1: x + size, y1: size });

describe("calmTrack", () => {
  it("ends exactly on both shapes, however different their sizes", () => {
    const looks = Array.from({ length: 13 }, (_, i) => square(10 - 0.75 * i, i));
    const track = calmTrack(looks);
    expect(boxAt(track, 0)).toEqual(looks[0]);
    expect(boxAt(track, 1)).toEqual(looks[12]);
  });

  it("stands still where the morph does", () => {
    expect(sameTrack(calmTrack(Array.from({ length: 13 }, () => square(2))), stillTrack(square(2), 13))).toBe(
      true,
    );
  });

  it("never jumps: no step is larger than the largest of the morph", () => {
    const looks = Array.from({ length: 13 }, (_, i) => square(i % 2 ? 1 : 2));
    const track = calmTrack(looks);
    for (let i = 0; i < 1000; i++) {
      const step = diagonal(boxAt(track, (i + 1) / 1000)) - diagonal(boxAt(track, i / 1000));
      expect(Math.abs(step)).toBeLessThan((12 / 1000) * 3);
    }
  });

  it("does not follow a morph that grows beyond measure, or has no shape", () => {
    const looks = [square(1), square(1e9), null, square(1)];
    expect(sameTrack(calmTrack(looks), stillTrack(square(1), 4))).toBe(true);
    expect(calmTrack([null, null])).toHaveLength(2);
    expect(calmTrack([])).toEqual([]);
  });
});

describe("boxAt", () => {
  it("clamps the time", () => {
    const track = [square(1), square(3)];
    expect(boxAt(track, -1)).toEqual(square(1));
    expect(boxAt(track, 9)).toEqual(square(3));
    expect(boxAt(track, Number.NaN)).toEqual(square(1));
    expect(boxAt(track, 0.5)).toEqual(square(2));
    expect(boxAt([square(2)], 0.7)).toEqual(square(2));
    expect(diagonal(boxAt([], 0.5))).toBeGreaterThan(0);
  });
});

describe("blendTracks", () => {
  it("goes from one to the other", () => {
    const [p, q] = [stillTrack(square(1), 3), stillTrack(square(3), 3)];
    expect(blendTracks(p, q, 0)).toEqual(p);
    expect(blendTracks(p, q, 1)).toEqual(q);
  });
});
