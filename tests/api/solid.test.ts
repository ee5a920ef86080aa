import { beforeAll, describe, expect, it } from "vitest";
import { loadSpace, refused, wrong } from "./frond";

let space: Awaited<ReturnType<typeof loadSpace>>;
beforeAll(async () => {
  space = await loadSpace();
});

function preset(id: string) {
  const found = space.presets3().find((one) => one.id === id);
  if (!found) throw new Error(`there is no preset ${id}`);
  return found.maps;
}
const tetrahedron = () => preset("tetrahedron");
const light = () => space.defaultSpace().light;
const view = () => space.defaultView(space.defaultSpace());
const objects = () => space.defaultSpace().objects;
const look = (width: number, height: number, factor: number) => ({
  width,
  height,
  factor,
  palette: [],
  ground: "#101418",
});
const lit = (pixels: ArrayLike<number>) =>
  Array.from(pixels).filter((byte, i) => i % 4 === 3 && byte > 0).length;

describe("space", () => {
  it("flattens a shape in the axes of its shadow, or of itself as the paper prints it", () => {
    const map = wrong([[0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.25, 0.35, 0.45]]);
    const along = (way: [number, number, number], options?: object) =>
      space.epsilonProjection(map, way, 0.5, wrong(options));
    // A call of three arguments answers as it always did: along z the shadow is seen mirrored in x.
    const picture = along([0, 0, 1]);
    expect(picture.maps).toEqual([[0.1, -0.2, -0.6, -0.4, 0.5, 1.2, -0.35, 0.4, 0.9, -0.25, 0.35, 0.225]]);
    expect(picture.diverging).toEqual([
      [0, 0],
      [0, 1],
    ]);
    expect(along([0, 0, 1], { frame: "picture" })).toEqual(picture);
    for (const z of [1, -1]) {
      const printed = along([0, 0, z], { frame: "space" });
      expect(printed.maps).toEqual([[0.1, 0.2, 0.6, 0.4, 0.5, 1.2, 0.35, 0.4, 0.9, 0.25, 0.35, 0.225]]);
      expect(printed.diverging).toEqual([
        [0, 0, 2],
        [0, 1, 2],
      ]);
    }
    expect(along([0, 1, 0], { frame: "space" }).diverging).toEqual([
      [0, 0, 1],
      [0, 2, 1],
    ]);
    expect(refused(() => along([0, 0, 1], { frame: "paper" }))).toBe("bad-input");
  });

  it("goes into a link and back", () => {
    const first = space.defaultSpace();
    expect(space.unpackSpace(space.packSpace(first))).toEqual(first);
    expect(refused(() => space.unpackSpace("o:nothing"))).toBe("space-damaged");
    expect(refused(() => space.packSpace(wrong({ objects: [] })))).toBe("space-count");
    expect(refused(() => space.packSpace(wrong({ objects: new Array(100_000).fill(1) })))).toBe(
      "space-count",
    );
    expect(refused(() => space.packSpace(wrong({ objects: 7 })))).toBe("bad-input");
  });

  it("has parameters that a turn and its inverse leave as they were", () => {
    const maps = tetrahedron();
    const turn = space.turning3([1, 2, 3], 0.7, [4, 5, 6]);
    const back = space.conjugate3(space.conjugate3(maps, turn), space.invert3(turn)).flat();
    for (const [i, x] of maps.flat().entries()) expect(back[i]).toBeCloseTo(x, 12);
    const flat = wrong([1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0]);
    expect(refused(() => space.conjugate3(maps, flat))).toBe("transform-singular");
    expect(refused(() => space.invert3(flat))).toBe("transform-singular");
    const tiny = wrong([1e-300, 0, 0, 0, 1e-300, 0, 0, 0, 1e-300, 0, 0, 0]);
    expect(refused(() => space.conjugate3(maps, tiny))).toBe("transform-scale");
    expect(refused(() => space.turning3([0, 0, 0], 1, [0, 0, 0]))).toBe("bad-input");
    const many = wrong(new Array(1_000_000).fill([]));
    expect(refused(() => space.validate3(many))).toBe("too-many-maps");
  });

  it("is carved and painted", () => {
    const picture = new space.SpacePicture(wrong(objects()));
    const carve = picture.carve(view(), 120, 90);
    while (!carve.run(20_000));
    const pixels = carve.paint(light(), look(60, 45, 2));
    expect(pixels).toHaveLength(60 * 45 * 4);
    expect(lit(pixels)).toBeGreaterThanOrEqual(300);
    expect(lit(pixels)).toBeLessThan(2600);
    expect(new Set(new Uint32Array(pixels.slice().buffer)).size).toBeGreaterThan(50);
    // Band by band it is the same.
    const bands = [
      [0, 40],
      [40, 90],
    ] as const;
    const parts = bands.map(([from, to]) => {
      const band = picture.carveRows(view(), 120, 90, from, to, 1);
      while (!band.run(20_000));
      expect([band.depth().length, band.codes().length]).toEqual([120 * (to - from), 120 * (to - from)]);
      return [...band.paint(light(), look(60, 45, 2))];
    });
    expect(parts.flat()).toEqual([...pixels]);
    expect(refused(() => picture.carveRows(view(), 120, 90, 40, 91, 1))).toBe("bad-input");
    expect(refused(() => picture.carveRows(view(), 120, 90, 40, 40, 1))).toBe("bad-input");
    expect(refused(() => carve.paint(light(), look(60, 45, 1)))).toBe("bad-input");
    expect(refused(() => picture.carve(view(), 0, 90))).toBe("bad-input");
    expect(refused(() => picture.carve(view(), 1e9, 90))).toBe("bad-input");
    expect(refused(() => picture.carve({ ...view(), distance: 0 }, 9, 9))).toBe("camera-no-direction");
    expect(refused(() => new space.SpacePicture([]))).toBe("bad-input");
  });

  it("is lit from what was carved before as it is painted at once, with shadows", () => {
    const picture = new space.SpacePicture(wrong(objects()));
    const bright = { ...light(), shadows: 0, occlusion: 0 };
    const paint = (lit: ReturnType<typeof light>) => {
      const carve = picture.carve(view(), 120, 90);
      while (!carve.run(20_000));
      return { pixels: carve.paint(lit, look(60, 45, 2)), depth: carve.depth(), codes: carve.codes() };
    };
    const { pixels, depth, codes } = paint(light());
    const sum = (bytes: ArrayLike<number>) => Array.from(bytes).reduce((all, byte) => all + byte, 0);
    // Shadows and occlusion take light away, and nothing else: the same pixels are lit.
    const without = paint(bright).pixels;
    expect(sum(without)).toBeGreaterThan(sum(pixels));
    expect(lit(without)).toBe(lit(pixels));
    expect(Array.from(pixels).every((byte, i) => byte <= (without[i] ?? 0) + 1)).toBe(true);
    const side = picture.lampSide(view(), light(), 60, 45);
    expect(picture.lampSide(view(), bright, 60, 45)).toBe(0);
    const seen = picture.carveLamp(view(), light(), 60, 45, 0, side);
    while (!seen.run(20_000));
    const lamp = seen.depth();
    expect(lamp).toHaveLength(side * side);
    const around = picture.lightReach(view(), light(), 1);
    const parts = [
      [0, 40],
      [40, 90],
    ].map(([from = 0, to = 0]) => {
      const top = Math.max(0, from - around);
      const [first, last] = [120 * top, 120 * Math.min(90, to + around)];
      const cut = [depth.slice(first, last), codes.slice(first, last)] as const;
      return [
        ...picture.lightRows(view(), light(), look(60, 45, 2), { top, rows: [from, to] }, ...cut, lamp, 1),
      ];
    });
    expect(parts.flat()).toEqual([...pixels]);
    const none = () =>
      picture.lightRows(
        view(),
        light(),
        look(60, 45, 2),
        { top: 0, rows: [0, 90] },
        depth,
        codes,
        lamp.slice(1),
        1,
      );
    expect(refused(none)).toBe("bad-input");
    expect(refused(() => picture.carveLamp(view(), bright, 60, 45, 0, 8))).toBe("bad-input");
    expect(refused(() => picture.carveLamp(view(), light(), 60, 45, 0, side + 1))).toBe("bad-input");
  });

  it("is seen alike at any size", () => {
    const carved = (scale: number) => {
      const scene = space.defaultSpace();
      const by = wrong([scale, 0, 0, 0, scale, 0, 0, 0, scale, 0, 0, 0]);
      const [first, ...rest] = scene.objects;
      if (!first) throw new Error("the space is empty");
      const maps = space.conjugate3(first.maps, by);
      const seen = space.defaultView({ ...scene, objects: [{ ...first, moved: by }, ...rest] });
      const carve = new space.SpacePicture([{ maps }]).carve(seen, 60, 45);
      while (!carve.run(20_000));
      return lit(carve.paint(light(), look(60, 45, 1)));
    };
    const plain = carved(1);
    for (const scale of [1e-60, 1e-9, 1e9, 1e60])
      expect(Math.abs(carved(scale) - plain), `${scale}`).toBeLessThan(40);
  });

  it("gives a renderer what it needs, of the right sizes", () => {
    const picture = new space.SpacePicture(wrong(objects()));
    const clouds = picture.clouds(40_000);
    expect(clouds).toHaveLength(1);
    expect(clouds[0]?.vertices.length).toBeGreaterThan(1000);
    expect(clouds[0]?.instances.length).toBeGreaterThan(1000);
    const bytes = picture.uniforms(view(), light(), look(60, 45, 2));
    expect(Object.keys(bytes)).toHaveLength(4);
    expect(bytes.lamp).toHaveLength(bytes.stillLamp.length);
  });

  it("has films, verdicts, paths and shadows", () => {
    const morph = space.unpackSpace("o:tetrahedron/to:dragon-curled/t:0.5");
    expect(new space.SpaceMotion(morph).at(0)).toMatchObject({ t: 0.5 });
    const uneven = space.unpackSpace("o:sponge/to:dragon-curled");
    expect(refused(() => new space.SpaceMotion(uneven))).toBe("map-counts");
    const verdict = (maps: unknown) => space.connectedness3(wrong(maps), undefined).verdict;
    expect(verdict(tetrahedron())).toBe("connected");
    expect(verdict(preset("dust"))).toBe("disconnected");
    expect(verdict([[2, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0]])).toBe("no-attractor");
    const locus = new space.SpaceLocus(tetrahedron(), preset("dragon-curled"), { width: 7, height: 7 });
    expect(locus.run(0, 7, 1).state).toHaveLength(49);
    expect(space.invariantDirections(tetrahedron())).toHaveLength(3);
    expect(space.projectExactly(tetrahedron(), [0, 0, 1])).toHaveLength(4);
    expect(refused(() => space.projectExactly(preset("dragon"), [0, 0, 1]))).toBe("project-not-kept");
    expect(refused(() => space.parseIfs3("a (3D) { 1 2 }"))).toBe("ifs-count");
    expect(space.parseIfs3(space.writeIfs3("tetra", tetrahedron()))).toHaveLength(1);
    // The second map has no weight: none is handed to another map.
    const rows = [" 0.7", "", " 0.2"].map((weight) => `.5 0 0 0 .5 0 0 0 .5 0 0 0${weight}\n`);
    expect(space.parseIfs3(`a (3D) {\n${rows.join("")}}`)).toMatchObject([
      { probabilities: [], remarks: [expect.stringMatching(/^Map 2 has no weight/)] },
    ]);
    const halves = wrong([
      [0.5, 0, 0, 0.5, 0, 0],
      [0.5, 0, 0, 0.5, 0.5, 0],
    ]);
    expect(space.lift(halves)).toHaveLength(2);
    for (const { first, second, isAttractor } of space.meetExamples())
      expect(space.intersection3(first, second, { points: 100 }).attractor !== null).toBe(isAttractor);
  });
});
