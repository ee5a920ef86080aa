import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import {
  allCodes,
  type Cube,
  cellOf,
  codeOf,
  codeWords,
  lettersOf,
  shuffled,
} from "../../www/src/figures/fujimoto/codes/codes";

/** The project's own copy, or the directory that FROND_KNOWN names. */
function known<T>(name: string): T[] {
  const folder = process.env["FROND_KNOWN"] ?? "tests/known";
  return JSON.parse(readFileSync(`${folder}/deform/${name}.json`, "utf8")).cases;
}

/** A line of so many parts, or a square of so many cells, as "line3" and "square9" name them. */
function cubeOf(name: string): Cube {
  const [, kind, count] = /^(line|square)(\d+)$/.exec(name) ?? [];
  if (!kind) throw new Error(`There is no cube "${name}".`);
  return kind === "line"
    ? { dimensions: 1, parts: Number(count) }
    : { dimensions: 2, parts: Math.sqrt(Number(count)) };
}

describe("codes of cubes", () => {
  it("name the cells that are known", () => {
    const cases = known<{
      cube: string;
      code: number[];
      cell_lower?: number[];
      cell_centre?: number[];
      point?: number[];
    }>("cube_address");
    expect(cases.length).toBeGreaterThan(0);
    for (const { cube: name, code, cell_lower = [], cell_centre, point } of cases) {
      const cube = cubeOf(name);
      expect(codeOf(cube, point ?? cell_centre ?? [], code.length)).toEqual(code);
      const { corner, side } = cellOf(cube, code);
      for (const [axis, low] of cell_lower.entries()) {
        expect(corner[axis]).toBeCloseTo(low, 12);
        expect((corner[axis] ?? Number.NaN) + side / 2).toBeCloseTo(cell_centre?.[axis] ?? Number.NaN, 12);
      }
    }
  });

  it("take points beyond the cube to its edge, and its upper edge to the last letter", () => {
    expect(codeOf({ dimensions: 2, parts: 2 }, [7, -1], 3)).toEqual([1, 1, 1]);
    expect(codeOf({ dimensions: 2, parts: 3 }, [1, 1], 2)).toEqual([8, 8]);
    expect(codeOf({ dimensions: 1, parts: 2 }, [0.5], 2)).toEqual([1, 0]);
    expect(lettersOf({ dimensions: 2, parts: 3 })).toBe(9);
  });
});

describe("a shuffle", () => {
  it("is the one that is known", () => {
    const cases = known<{ code: number[]; kb: number; ke: number; out: number[] }>("codes");
    expect(cases.length).toBeGreaterThan(10);
    for (const { code, kb, ke, out } of cases) {
      expect(shuffled(code, kb, ke)).toEqual(out);
      expect(shuffled(out, kb, ke)).toEqual(code);
    }
  });
  it("leaves a block of no letter or of one", () => {
    expect(shuffled([1, 2, 3], 1, 1)).toEqual([1, 2, 3]);
    expect(shuffled([1, 2, 3], 1, 2)).toEqual([1, 2, 3]);
  });
});

it("shows letters from 1, and lists all codes in order", () => {
  expect(codeWords([0, 2, 1])).toBe("132");
  expect(codeWords([0, 9])).toBe("1 10");
  expect(allCodes(2, 2)).toEqual([
    [0, 0],
    [0, 1],
    [1, 0],
    [1, 1],
  ]);
  expect(allCodes(3, 0)).toEqual([[]]);
});
