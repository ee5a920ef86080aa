import { expect, it } from "vitest";
import type { HoughCluster } from "#workers/fit/hough";
import { firstLook, tableThree } from "../find/search";
import { TABLE_3 } from "../printed";
import { aboutOf, axisWords, costWords, errorWords, nameOf, offWords } from "./graph-text";

const cluster = (over: Partial<HoughCluster>): HoughCluster => ({
  hits: 9,
  map: [0.5, 0, 0.5, 0, 0],
  at: [0, 0, 0, 0, 0],
  place: [0, 0, 0, 0, 0],
  kind: "map",
  echo: [],
  candidate: null,
  ...over,
});

it("names clusters by what they are", () => {
  expect(nameOf(cluster({}), 0)).toBe("Map 1");
  expect(nameOf(cluster({ kind: "clutter" }), 4)).toBe("Clutter 5");
  const echo = cluster({
    kind: "echo",
    echo: [
      { cluster: 0, inverse: false },
      { cluster: 1, inverse: true },
    ],
  });
  expect(nameOf(echo, 2)).toBe("Echo 1 2⁻¹");
  // The last letter is done first.
  expect(aboutOf(echo)).toContain("undo map 2, then apply map 1");
  expect(errorWords(cluster({}))).toBe("fits nowhere");
});

it("looks first at the strongest map, never at clutter", () => {
  const [clutter, echo, map] = (["clutter", "echo", "map"] as const).map((kind) => cluster({ kind }));
  if (!clutter || !echo || !map) throw new Error("there are three");
  expect(firstLook([clutter, echo, map])).toBe(2);
  expect(firstLook([clutter, echo])).toBe(1);
  expect(firstLook([clutter])).toBeNull();
  expect(firstLook([])).toBeNull();
});

it("says how far off a graph is in the units of its heights", () => {
  expect(offWords({ worst: 31.26, meanSquare: 123 })).toBe("error 31.3 at most, 11.1 RMS");
});

it("says what a graph costs beside a polyline", () => {
  const graph = (c: number) => ({
    kind: "fif" as const,
    pieces: [
      {
        map: [0.5, 0, c, 0, 0] as [number, number, number, number, number],
        domain: [0, 1] as [number, number],
      },
    ],
  });
  expect(costWords({ numbers: 8, polyline: 40, graph: graph(0.4) })).toBe(
    "It takes 8 numbers; a polyline of the same accuracy takes 40.",
  );
  expect(costWords({ numbers: 40, polyline: 40, graph: graph(0) })).toContain("copies save nothing");
  expect(costWords({ graph: graph(0.4) })).toBe("");
});

it("says a direction in its largest parts", () => {
  expect(axisWords([0.1, 0.9, -0.4, 0, 0.1])).toBe("0.9 b − 0.4 c");
});

it("finds the seven maps of the paper among clusters, and nothing that is none of them", () => {
  const seven = TABLE_3.pieces.map(({ map }) => cluster({ map }));
  const other = cluster({ map: [0.7, 0.2, 0.1, 0, 0] });
  const picks = tableThree([other, ...seven]);
  expect(picks.map((pick) => pick.cluster)).toEqual([1, 2, 3, 4, 5, 6, 7]);
  expect(picks[3]?.domain).toEqual([0, 1]);
  expect(tableThree([other])).toEqual([]);
});
