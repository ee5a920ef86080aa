import { expect, it, vi } from "vitest";
import type { Ifs, MapRow, Shape } from "#wasm/api";
import type { PlaneMoment } from "#workers/film/plane-drawer";

// The module itself is left out: where the morph goes between two rows of numbers is no matter here.
vi.mock("#wasm/core", () => {
  const between = (p: readonly number[], q: readonly number[], u: number) =>
    p.map((x, i) => (1 - u) * x + u * (q[i] ?? 0));
  return {
    frond: {
      pair: (a: Ifs, b: Ifs) => ({
        from: a.maps,
        to: b.maps,
        steps: [],
        probabilities: [a.probabilities, b.probabilities],
      }),
      interpolate: (a: Ifs, b: Ifs, { u }: { u: number }) => ({
        maps: a.maps.map((map, i) => between(map, b.maps[i] ?? map, u)),
        probabilities: between(a.probabilities ?? [], b.probabilities ?? [], u),
      }),
      bounds: () => ({ box: [0, 0, 1, 1], hull: [] }),
    },
  };
});
const drawn = vi.hoisted(() => ({ at: (_seconds: number): unknown => null }));
vi.mock("#workers/film/plane-drawer", () => ({
  planeDrawer: (_look: unknown, _alone: boolean, at: typeof drawn.at) => {
    drawn.at = at;
  },
}));
const { scene, start } = await import("#document/scene");
const { films } = await import("./film");

const shape = (scale: number, weights: number[]): Shape => {
  const map = (x: number): MapRow => [scale, 0, 0, scale, x, 0];
  return { name: "", maps: [map(0), map(0.5)], weights };
};
const look = { width: 64, height: 36, smooth: false, ground: "#ffffff" };

it("films what stood there when it was asked, whatever the document becomes while it is made", async () => {
  start({
    ...scene.peek(),
    a: shape(0.5, [1, 3]),
    b: shape(0.25, [3, 1]),
    path: { kind: "straight", points: [] },
  });
  const { subjects } = await films();
  const [morph] = subjects;
  morph?.drawer(look);
  const moments = () =>
    [0, 0.25, 0.5, 1].map((part) => drawn.at(part * (morph?.seconds ?? 0)) as PlaneMoment);
  const before = moments();
  expect(before.map(({ maps }) => maps[0]?.[0])).toEqual([0.5, 0.4375, 0.375, 0.25]);
  expect(before.map(({ weights }) => weights?.[0])).toEqual([1, 1.5, 2, 3]);

  start({
    ...scene.peek(),
    a: shape(0.1, [1, 1]),
    b: shape(0.2, [1, 1]),
    mode: "linear",
    path: { kind: "drawn", points: [[0.9, 0.1]] },
    colouring: "address",
    palette: ["#ff0000"],
  });
  expect(moments()).toEqual(before);
  // So is a preview of it that is drawn anew.
  morph?.drawer(look);
  expect(moments()).toEqual(before);
});
