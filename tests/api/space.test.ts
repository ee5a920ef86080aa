import { readFile } from "node:fs/promises";
import { beforeAll, beforeEach, describe, expect, it, vi } from "vitest";
import type { MapRow3, Point3, SpaceView } from "../../www/src/wasm/api";
import { solid, startSpace } from "../../www/src/wasm/space";

vi.mock("../../www/src/wasm/module", () => ({
  once: (get: () => Promise<unknown>) => get,
  compiled: async () =>
    WebAssembly.compile(await readFile(new URL("../../www/pkg/frond-space_bg.wasm", import.meta.url))),
}));

const { redo, scene, start, undo } = await import("../../www/src/document/scene");
const state = await import("../../www/src/document/space/space");
const edits = await import("../../www/src/document/space/edits");
const { standFor } = await import("../../www/src/tools/space/stage/sight");
const { showsAll, wholeView } = await import("../../www/src/tools/space/stage/camera");

const first = { ...scene.peek() };
const moved = (x: number): MapRow3 => [1, 0, 0, 0, 1, 0, 0, 0, 1, x, 0, 0];
const view: SpaceView = { target: [0, 0, 0], distance: 5, turn: 1, tilt: 0.2, angle: 0.7 };
const now = () => state.spaceFrame.value?.objects[0];
const part = () => state.spacePart.value;

beforeAll(async () => {
  const module = await WebAssembly.compile(
    await readFile(new URL("../../www/pkg/frond-space_bg.wasm", import.meta.url)),
  );
  await startSpace(module);
  await state.openSpace();
});

beforeEach(() => start({ ...first, space: { packed: "o:tetrahedron", at: 0 } }));

describe("a hand", () => {
  it("moves the parameters, and undo brings back every bit", () => {
    const before = now();
    edits.moveObject(solid.turning3([1, 2, 3], 0.3, [0, 0, 0]));
    expect(now()?.now).not.toEqual(before?.now);
    undo();
    expect(now()).toEqual(before);
    redo();
    expect(now()?.moved).not.toEqual(before?.moved);
  });

  it("is refused what cannot be undone, and nothing changes", () => {
    const before = scene.peek();
    expect(() => edits.moveObject([1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0])).toThrow();
    expect(scene.peek()).toBe(before);
  });
});

describe("with a time line", () => {
  beforeEach(() => {
    edits.addKey();
    state.setMoment(2);
    edits.moveObject(moved(1));
  });

  it("what is moved is kept at its moment", () => {
    expect(part().packed.match(/\/k:/g)).toHaveLength(2);
    expect(now()?.moved[9]).toBeCloseTo(1);
    state.setMoment(0);
    expect(now()?.moved[9]).toBeCloseTo(0);
  });

  it("the maps of a moment leave those of the other keys", () => {
    const made = now()?.maps ?? [];
    const other = made.map((map, i) => (i === 0 ? (map.with(9, (map[9] ?? 0) + 0.2) as MapRow3) : map));
    edits.changeMaps(other);
    expect(now()?.maps[0]?.[9]).toBeCloseTo(other[0]?.[9] ?? 0);
    state.setMoment(0);
    expect(now()?.maps[0]?.[9]).toBeCloseTo(made[0]?.[9] ?? 0);
    state.setMoment(1);
    expect(now()?.maps[0]?.[9]).toBeGreaterThan(made[0]?.[9] ?? 0);
  });

  it("what cannot be played is refused", () => {
    const before = part().packed;
    expect(() => edits.moveObject([-1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0])).toThrow();
    expect(part().packed).toBe(before);
    expect(state.spaceFrame.value?.objects).toHaveLength(1);
  });

  it("what is looked at goes into the link, until the moment changes", () => {
    state.setView(view);
    expect([state.lookingAround.value, part().own, state.spaceView.value]).toEqual([true, true, view]);
    state.setMoment(2);
    expect([state.lookingAround.value, part().own]).toEqual([false, undefined]);
    state.setView(view);
    edits.addKey();
    expect(state.lookingAround.value).toBe(false);
    undo();
    expect([state.lookingAround.value, state.spaceView.value]).toEqual([true, view]);
  });

  it("what is seen stays when the keys go", () => {
    const made = now()?.maps ?? [];
    edits.changeMaps(made.map((map, i) => (i === 0 ? (map.with(9, (map[9] ?? 0) + 0.2) as MapRow3) : map)));
    edits.changeTimeline((line) => ({ ...line, seconds: 20 }));
    state.setMoment(1.3);
    const [before, seen] = [now(), state.spaceView.value];
    edits.endTimeline();
    expect(state.timeline.value).toBeNull();
    expect(now()?.moved[9]).toBeGreaterThan(0.1);
    for (const [i, map] of (now()?.now ?? []).entries()) {
      for (const [k, x] of map.entries()) expect(x).toBeCloseTo(before?.now[i]?.[k] ?? Number.NaN, 6);
    }
    expect(state.moment.value).toBe(1.3);
    expect(state.spaceView.value?.distance).toBeCloseTo(seen?.distance ?? 0, 4);
    undo();
    expect(state.timeline.value?.keys).toHaveLength(2);
  });

  it("no moment is beyond the end when the keys are gone", () => {
    edits.changeTimeline((line) => ({ ...line, seconds: 20 }));
    state.setMoment(15);
    edits.endTimeline();
    expect(state.moment.value).toBe(edits.EMPTY_LINE.seconds);
  });

  it("a moment beyond the end is the end", () => {
    state.setMoment(500);
    edits.moveObject(moved(1));
    expect(part().at).toBe(edits.EMPTY_LINE.seconds);
  });
});

describe("a view", () => {
  it("that is none is not taken", () => {
    state.setView(view);
    for (const bad of [{ distance: 0 }, { turn: Number.NaN }, { target: [1e200, 0, 0] }, { angle: 4 }]) {
      expect(state.setView({ ...view, ...bad } as SpaceView)).toBe(false);
    }
    expect(state.spaceView.value).toEqual(view);
  });

  it("stays where it is when what is seen moves", () => {
    const before = state.spaceView.value;
    edits.moveObject(moved(3));
    expect(state.spaceView.value).toEqual(before);
  });
});

describe("a mesh", () => {
  const tetrahedron = () => solid.presets3().find(({ id }) => id === "tetrahedron")?.maps ?? [];

  it("is made in steps and written as three kinds of file", () => {
    const mesher = new solid.SpaceMesher([{ maps: tetrahedron(), tint: "#ff8000" }], {
      fineness: 32,
      size: 50,
      wall: 4,
    });
    while (!mesher.run(500)) expect(mesher.found).toBeGreaterThan(0);
    const mesh = mesher.finish();
    const facts = mesh.facts();
    expect(facts).toMatchObject({ parts: 1 });
    expect(facts.size.map(Math.round)).toEqual([50, 50, 50]);
    expect(facts.wall).toBeCloseTo(4.6875);
    const [stl, ply, glb] = (["stl", "ply", "glb"] as const).map((format) => mesh.file(format, ["#000000"]));
    expect(stl?.length).toBe(84 + 50 * facts.triangles);
    expect(solid.meshBytes("stl", facts.triangles)).toBe(stl?.length);
    const head = new TextDecoder().decode(ply?.slice(0, 400));
    expect(head).toContain(`element face ${facts.triangles}\n`);
    // The first vertex has the colour of its object.
    const vertex = head.indexOf("end_header\n") + 11;
    expect([...(ply?.slice(vertex + 24, vertex + 27) ?? [])]).toEqual([255, 128, 0]);
    expect(new TextDecoder().decode(glb?.slice(0, 4))).toBe("glTF");
    mesh.free();
  });

  it("is refused with what to do", () => {
    const make = (objects: { maps: MapRow3[] }[], options: object) => {
      try {
        new solid.SpaceMesher(objects, { fineness: 64, size: 100, wall: 1, ...options }).free();
        return "";
      } catch (problem) {
        const { code, message } = problem as { code: string; message: string };
        return `${code}: ${message}`;
      }
    };
    const objects = [{ maps: tetrahedron() }];
    expect(make(objects, {})).toBe("");
    expect(make([], {})).toMatch(/^bad-input: /);
    expect(make(objects, { fineness: 600 })).toMatch(/^mesh-too-fine: .*lower fineness/);
    expect(make(objects, { wall: 95 })).toMatch(/^mesh-wall: .*thinner/);
    expect(make(objects, { size: Number.NaN })).toMatch(/^mesh-size: /);
  });
});

describe("the whole view", () => {
  it("misses no corner of a shape, in a picture of any form", () => {
    const cube = solid.unpackSpace("o:sponge").objects[0];
    const points = standFor(cube?.maps ?? []);
    // The sponge has the corners of the unit cube.
    const corners = [0, 1].flatMap((x) => [0, 1].flatMap((y) => [0, 1].map((z): Point3 => [x, y, z])));
    for (const aspect of [0.3, 0.7, 1, 2]) {
      const from = (turn: number): SpaceView => ({ ...view, turn, target: [0.5, 0.5, 0.5] });
      for (const turn of [0, 0.4, 0.8, 1.2]) {
        expect(showsAll(wholeView(from(turn), points, aspect), corners, aspect)).toBe(true);
        const near: SpaceView = { ...from(turn), distance: 2.2 };
        expect(showsAll(near, points, aspect)).toBe(showsAll(near, corners, aspect));
      }
    }
  });
});
