import { beforeEach, expect, test, vi } from "vitest";
import type { MapRow3, SpaceLight, SpaceView } from "#wasm/api";
import type { Context } from "../lanes/task";
import { objectAt, pictureTasks } from "./picture";

/** Stands in for what carves: a picture is done after so many slices. */
const carving = vi.hoisted(() => ({ slices: 1, made: 0, freed: 0, carves: 0, carvesFreed: 0, sizes: "" }));
vi.mock("#wasm/space", () => {
  class SpacePicture {
    constructor() {
      carving.made++;
    }
    carve(view: unknown, width: number, height: number) {
      return this.carveRows(view, width, height, 0, height);
    }
    carveRows(_view: unknown, width: number, height: number, from: number, to: number, _reach = 0) {
      carving.carves++;
      carving.sizes = `${width} x ${height}`;
      const rows = to - from;
      let left = carving.slices;
      return {
        run: () => --left <= 0,
        depth: () => new Float32Array(width * rows),
        codes: () => new Uint32Array(width * rows),
        paint: (_light: unknown, look: { width: number; factor: number }) =>
          new Uint8ClampedArray((4 * look.width * rows) / look.factor),
        free: () => carving.carvesFreed++,
      };
    }
    next() {
      return new SpacePicture();
    }
    free() {
      carving.freed++;
    }
  }
  return { solid: { SpacePicture } };
});

const HALF: MapRow3 = [0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5, 0, 0, 0];
const view: SpaceView = { target: [0, 0, 0], distance: 1, turn: 0, tilt: 0, angle: 1 };
const light: SpaceLight = { paint: "map", side: 0, front: 0, ambient: 0, hollows: 0, fog: 0 };
const request = {
  objects: [{ maps: [HALF] }],
  view,
  light,
  width: 6,
  height: 4,
  factor: 2 as const,
  palette: [],
  ground: "#ffffff",
};

let breaths = 0;
let handed: Transferable[] = [];
const context: Context = {
  progress() {},
  async breathe() {
    breaths++;
  },
  transfer: (...values) => handed.push(...values),
  keep: new Map(),
};

beforeEach(() => {
  Object.assign(carving, { slices: 1, made: 0, freed: 0, carves: 0, carvesFreed: 0 });
  breaths = 0;
  handed = [];
  context.keep.clear();
});

test("it carves more pixels than it paints, in slices, and hands the picture over", async () => {
  carving.slices = 5;
  let now = 0;
  const clock = vi.spyOn(performance, "now").mockImplementation(() => (now += 20));
  const { width, height, data } = await pictureTasks.picture(context, request);
  expect([width, height, data.length]).toEqual([6, 4, 96]);
  expect(carving.sizes).toBe("12 x 8");
  clock.mockRestore();
  expect(breaths).toBe(4);
  expect(handed).toEqual([data.buffer]);
});

test("a band has its rows alone, and tells which pieces are seen if it is asked", async () => {
  const band = { ...request, rows: [2, 6] as const, reach: 1 };
  const plain = await pictureTasks.band(context, { ...band, codes: false });
  expect([plain.data.length, plain.codes]).toEqual([4 * 6 * 2, null]);
  const told = await pictureTasks.band(context, { ...band, codes: true });
  expect([told.data.length, told.codes?.length]).toEqual([4 * 6 * 2, 12 * 4]);
  const relief = await pictureTasks.relief(context, { ...request, rows: [1, 4] });
  expect([relief.width, relief.height, relief.depth.length]).toEqual([6, 3, 18]);
});

test("a small picture is not kept waiting by breaths", async () => {
  carving.slices = 5;
  const clock = vi.spyOn(performance, "now").mockReturnValue(0);
  await pictureTasks.picture(context, request);
  clock.mockRestore();
  expect(breaths).toBe(0);
});

test("objects are made ready once for as long as they are the same", async () => {
  const { objects } = request;
  await pictureTasks.picture(context, request);
  const relief = await pictureTasks.relief(context, { objects, view, width: 3, height: 3 });
  expect(relief).toMatchObject({ width: 3, height: 3, empty: true });
  expect(carving).toMatchObject({ made: 1, freed: 0 });
  const others = [{ maps: [HALF, HALF] }];
  await pictureTasks.relief(context, { objects: others, view, width: 3, height: 3 });
  expect(carving).toMatchObject({ made: 2, freed: 1 });
});

test("what is called off is let go", async () => {
  carving.slices = 1e9;
  const stopping: Context = {
    ...context,
    breathe: () => Promise.reject({ code: "stopped", message: "Another picture was requested." }),
  };
  await expect(pictureTasks.picture(stopping, request)).rejects.toMatchObject({ code: "stopped" });
  expect(carving).toMatchObject({ carves: 1, carvesFreed: 1 });
});

test("a place of a relief belongs to an object, or to none", () => {
  const codes = new Uint32Array(6);
  codes[4] = 1 + (5 << 18) + 77;
  codes[2] = 1;
  const relief = { width: 3, height: 2, depth: new Float32Array(6), codes, empty: false };
  expect(objectAt(relief, 0.5, 0.75)).toBe(5);
  expect(objectAt(relief, 0.99, 0.2)).toBe(0);
  expect(objectAt(relief, 0.1, 0.1)).toBeNull();
  expect(objectAt(relief, 1, 0.5)).toBeNull();
});
