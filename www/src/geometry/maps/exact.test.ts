import { describe, expect, it } from "vitest";
import type { MapRow, Shape } from "#wasm/api";
import { carriedExact, doubles, exactOf, GALLERY, withExact } from "./exact";

const third = 0.3333333333333333;
const root = 0.28867513459481287;
const koch: Shape = {
  preset: "koch",
  name: "Koch",
  maps: [
    [third, 0, 0, third, 0, 0],
    [0.16666666666666666, -root, root, 0.16666666666666666, third, 0],
  ],
};

GALLERY.set("koch", "1/3,2/3,1/6,sqrt(3)/6");

describe("exact numbers of a shape", () => {
  it("are those of the gallery for a shape of the gallery, and its own formulas for any other", () => {
    expect(exactOf(koch)).toEqual(["1/3", "2/3", "1/6", "sqrt(3)/6"]);
    expect(exactOf({ name: "Own", maps: koch.maps })).toEqual([]);
    expect(exactOf({ name: "Own", maps: koch.maps, exact: ["1/3"] })).toEqual(["1/3"]);
  });

  it("stay while an entry means them, and are given up with the last one", () => {
    const dragged: MapRow[] = [[0.34, 0, 0, 0.34, 0, 0], ...koch.maps.slice(1)];
    expect(carriedExact(koch, "Koch", dragged).exact).toEqual(["1/3", "2/3", "1/6", "sqrt(3)/6"]);
    const [first] = koch.maps;
    for (const [formula, size] of [
      ["1/3", third],
      ["2/3", 2 * third],
      ["1/6", 0.16666666666666666],
      ["sqrt(3)/6", root],
    ] as const)
      doubles.set(formula, size);
    expect(carriedExact(koch, "Koch", first ? [first] : []).exact).toEqual(["1/3"]);
    expect(carriedExact(koch, "Koch", [[0.34, 0, 0, 0.34, 0, 0]])).toEqual({
      name: "Koch",
      maps: [[0.34, 0, 0, 0.34, 0, 0]],
    });
  });

  it("come first where they are new, and formulas of which nothing is known stay", () => {
    const shape: Shape = { name: "Own", maps: [[third, 0, 0, third, 0, 0]], exact: ["1/3", "cos(40deg)/2"] };
    expect(carriedExact(shape, "Own", shape.maps, ["cos(20deg)"]).exact).toEqual([
      "cos(20deg)",
      "1/3",
      "cos(40deg)/2",
    ]);
    doubles.set("cos(40deg)/2", 0.38302222155948906);
    doubles.set("1/3", third);
    expect(carriedExact(shape, "Own", shape.maps).exact).toEqual(["1/3"]);
  });

  it("are none where the list is empty", () => {
    expect(withExact({ ...koch, exact: ["1/3"] }, [])).toEqual(koch);
  });
});
