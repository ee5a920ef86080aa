/** How often the chaos game takes each map: from a link to the pixels of the density, and what does not hang on it. */
import { readFile } from "node:fs/promises";
import { beforeAll, expect, it } from "vitest";
import init, { LinkedMorph } from "../../www/pkg/frond-morph.js";
import * as frond from "../../www/pkg/index.js";
import { load } from "./frond";

beforeAll(async () => {
  const file = new URL("../../www/pkg/frond-morph_bg.wasm", import.meta.url);
  await Promise.all([load(), init({ module_or_path: readFile(file) })]);
});

const mapsOf = (id: string) => frond.presets().find((preset) => preset.id === id)?.maps ?? [];
const sum = (list: readonly number[] = []) => list.reduce((all, one) => all + one, 0);

it("goes with the maps where they are split, and is told only where it was given", () => {
  const [dragon, gasket] = [mapsOf("twindragon"), mapsOf("gasket")];
  expect(frond.pair({ maps: dragon }, { maps: gasket })).not.toHaveProperty("probabilities");
  const { from, probabilities } = frond.pair({ maps: dragon, probabilities: [1, 3] }, { maps: gasket });
  const [p = [], q] = probabilities ?? [];
  expect([from.length, p.length, sum(p)]).toEqual([3, 3, 1]);
  expect(p.toSorted((a, b) => a - b)).not.toEqual([0.25, 0.25, 0.5]);
  for (const share of q ?? []) expect(share).toBeCloseTo(1 / 3, 12);
});

it("goes from that of one shape to that of the other", () => {
  const maps = mapsOf("gasket");
  const ends: [frond.Ifs, frond.Ifs] = [
    { maps, probabilities: [0.5, 0.25, 0.25] },
    { maps, probabilities: [0.2, 0.3, 0.5] },
  ];
  const at = (u: number, correspondence = [0, 1, 2]) =>
    frond.interpolate(...ends, { u, v: u, correspondence }).probabilities;
  expect(at(0)).toEqual([0.5, 0.25, 0.25]);
  expect(at(1, [2, 0, 1])).toEqual([0.5, 0.2, 0.3]);
  expect(at(0.5)?.map((share) => share.toFixed(4))).toEqual(["0.3500", "0.2750", "0.3750"]);
  expect(frond.interpolate({ maps }, ends[1], { u: 0.5, v: 0.5 })).not.toHaveProperty("probabilities");
});

it("is in a link, and in the picture that others draw of it", () => {
  const link = "v=1&a=gasket&a-weights=1,2,6&b=koch&colour=density";
  const { scene, problem } = frond.decodeScene(link);
  expect([scene.a.weights, scene.b.weights, problem]).toEqual([[1, 2, 6], undefined, undefined]);
  expect(frond.encodeScene(scene)).toContain("a=gasket&a-weights=1,2,6&b=koch");
  const {
    from,
    to,
    probabilities: [p, q] = [],
  } = frond.pair({ maps: scene.a.maps, probabilities: [1, 2, 6] }, { maps: scene.b.maps });
  const ifs = frond.interpolate(
    { maps: from, probabilities: p ?? [] },
    { maps: to, probabilities: q ?? [] },
    { u: 0.25, v: 0.25 },
  );
  const view = { x: 0.5, y: 0.3, scale: 50 };
  const picture = { width: 60, height: 50, view, colouring: "density" as const, palette: ["#ffffff"] };
  const drawn = new LinkedMorph(link).draw(0.25, 0.25, 0, 60, 50, 0.5, 0.3, 50, Uint32Array.of(0xffffff));
  expect([...drawn]).toEqual([...frond.rasterize(ifs, picture)]);
  expect([...drawn]).not.toEqual([...frond.rasterize({ maps: ifs.maps }, picture)]);
  // Of every other picture no pixel hangs on it.
  const plain = { ...picture, colouring: "map" as const };
  expect(frond.rasterize(ifs, plain)).toEqual(frond.rasterize({ maps: ifs.maps }, plain));
});
