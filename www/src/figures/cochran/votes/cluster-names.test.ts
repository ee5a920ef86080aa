import { describe, expect, it } from "vitest";
import type { HoughCluster } from "#workers/fit/hough";
import known from "../../../../../tests/known/fit/table2.json";
import { after, inverse, type ShearMap, TABLE_1, TABLE_2 } from "../graphs/printed-tables";
import { apartIn, kindWords, letterOf, nearestOf } from "./cluster-names";
import { added } from "./votes";

const cluster = (map: ShearMap, rest: Partial<HoughCluster> = {}): HoughCluster => ({
  hits: 1,
  map,
  at: map,
  place: map,
  kind: "map",
  echo: [],
  candidate: null,
  ...rest,
});
const [one, two] = TABLE_1.map(({ map }) => map) as [ShearMap, ShearMap];

describe("the rows of Table 2", () => {
  it("are the maps of Table 1 and compositions of them", () => {
    for (const { table2, word, abcde } of known.rows) {
      const printed = table2.slice(1) as ShearMap;
      const row = TABLE_2.find(({ hits }) => hits === table2[0]);
      expect(row?.map).toEqual(printed);
      const composed = word
        .map((letter) => {
          const map = letter.startsWith("1") ? one : two;
          return letter.endsWith("i") ? inverse(map) : map;
        })
        .reduce(after);
      expect(apartIn(composed, abcde as ShearMap)).toBeLessThan(1e-6);
      expect(apartIn(composed, printed)).toBeLessThan(1);
    }
  });

  it("are not taken for each other", () => {
    const maps = TABLE_2.map(({ map }) => map);
    expect(maps.map((map) => nearestOf(map, maps))).toEqual([0, 1, 2, 3, 4]);
    expect(nearestOf([0.9, 0, 0.1, 0, 0], maps)).toBeNull();
    expect(nearestOf(one, [])).toBeNull();
  });
});

describe("names", () => {
  const found = [
    cluster(two),
    cluster([0.1, 0, 0.1, 0, 0], { kind: "clutter" }),
    cluster(one),
    cluster([0.5, -0.9, 0.5, 0, 0.5], {
      kind: "echo",
      echo: [
        { cluster: 0, inverse: false },
        { cluster: 2, inverse: true },
      ],
    }),
  ];

  it("are those of Table 1 where a map is one of its two", () => {
    const letter = (index: number) => letterOf(found, index);
    expect(found.map((_, i) => letter(i))).toEqual(["T₂", "#2", "T₁", "#4"]);
    expect(found.map((one_, i) => kindWords(one_, i, letter))).toEqual([
      "T₂ itself",
      "clutter",
      "T₁ itself",
      "echo: T₂ T₁⁻¹",
    ]);
  });

  it("are ranks without it", () => {
    expect(found.map((one_, i) => kindWords(one_, i))).toEqual([
      "a map",
      "clutter",
      "a map",
      "echo: #1 #3⁻¹",
    ]);
  });
});

it("adds counts of both workers", () => {
  expect(added([undefined, undefined])).toBeNull();
  expect(added([Uint32Array.of(1, 2), undefined])).toEqual(Uint32Array.of(1, 2));
  expect(added([Uint32Array.of(1, 2), Uint32Array.of(3, 4)])).toEqual(Uint32Array.of(4, 6));
});
