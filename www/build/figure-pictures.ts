/** What is in the picture of each figure and lesson: what it is about, drawn by itself or a few side by side. */
import type { Bend, MapRow } from "../../crate/web/src/api";
import type { Cell, Shape, Source } from "./pictures.ts";

const plane = (maps: number[][]): Cell => ({ maps: maps as MapRow[] });

/** Four copies in the corners of a square: apart below a half. */
const corners = (scale: number): Cell =>
  plane([0, 1].flatMap((x) => [0, 1].map((y) => [scale, 0, 0, scale, x * (1 - scale), y * (1 - scale)])));

/** Three in those of a triangle. */
const triangleOf = (scale: number) =>
  [0, 1, 2].map((k) => {
    const angle = (Math.PI * (4 * k + 3)) / 6;
    return [scale, 0, 0, scale, (1 - scale) * Math.cos(angle), (1 - scale) * Math.sin(angle)];
  });
const triangle = (scale: number): Cell => plane(triangleOf(scale));

/** A fractal function through points at even distances (Barnsley 1986): each map takes the ends to two neighbours. */
function rough(heights: readonly number[], roughness: number): Cell {
  const count = heights.length - 1;
  const [first = 0, last = 0] = [heights[0], heights[count]];
  return plane(
    Array.from({ length: count }, (_, i) => {
      const [from = 0, to = 0] = [heights[i], heights[i + 1]];
      const slope = to - from - roughness * (last - first);
      return [1 / count, 0, slope, roughness, i / count, from - roughness * first];
    }),
  );
}

/** A mesh with one point pulled. */
function bent({ maps }: Shape, [dx, dy]: [number, number], delta: number, { bounds }: Source): Cell {
  const { min, max } = bounds(maps);
  const size = Math.max(max[0] - min[0], max[1] - min[1]);
  const moves = [0, 0, 0, 0, 0, 0, dx * size, dy * size];
  const box: Bend["box"] = [...min, ...max];
  const bend: Bend = {
    columns: 2,
    rows: 2,
    box,
    moves,
    kb: 0,
    ke: 5,
    delta,
    spin: "rotation",
    continuity: "auto",
    superposed: true,
  };
  return { maps: maps as MapRow[], bend };
}

const TIMES = [0, 0.25, 0.5, 0.75, 1];
/** The way on which dragon and gasket hold together (Burch & Hart 1997, Figure 6). */
const LED: [u: number, v: number][] = [
  [0, 0],
  [-0.125, 1.156],
  [0.5, 1.766],
  [0.938, 1.578],
  [1, 1],
];

/** By the figure's id; what there are several of lies in a grid of so many columns. */
export function figurePictures(source: Source): Record<string, { cells: Cell[]; columns?: number }> {
  const { shape, between, moved, family, solid, space } = source;
  const one = (id: string) => ({ cells: [plane(shape(id).maps)] });
  const row = (...cells: Cell[]) => ({ cells });
  const morph = (a: string, b: string, u: number, v = u, linear = false) =>
    plane(between(shape(a), shape(b), u, v, linear));
  const way = (a: string, b: string) => row(...TIMES.map((t) => morph(a, b, t)));
  const led = (points: readonly [number, number][]) =>
    row(...points.map(([u, v]) => morph("dragon-3", "gasket", u, v)));
  const turned = (id: string, ...turns: number[]) => row(...turns.map((turn) => ({ ...solid(id), turn })));
  const pulled = (id: string, by: [number, number], ...deltas: number[]) =>
    row(...deltas.map((delta) => bent(shape(id), by, delta, source)));
  const polygon = (sides: number, ...params: [number, number][]) =>
    row(...params.map((s) => plane(family(sides, s))));
  const of = (id: string) => solid(id).solid.flatMap(({ maps }) => maps);
  const [meet] = space.meetExamples();

  return {
    "1": row(corners(0.4), corners(0.45), corners(0.49)),
    "2": row(morph("dragon-3", "gasket", 0.6)),
    "3": row(...[false, true].map((linear) => morph("koch", "twindragon", 0.5, 0.5, linear))),
    "5": way("dragon-3", "gasket"),
    "6": led(LED),
    "7": {
      cells: [1.4, 0.7, 0].flatMap((v) =>
        [0, 0.25, 0.5, 0.75, 1].map((u) => morph("dragon-3", "gasket", u, v)),
      ),
      columns: 5,
    },
    "section-7": row(plane(shape("koch").maps), plane(shape("dragon").maps)),
    "table-1": row(triangle(0.46), triangle(0.48), triangle(0.5)),
    d1: one("carpet"),
    d2: one("gasket"),
    d3: pulled("vicsek", [0.2, 0.1], 0.5),
    d4: pulled("gasket", [0.3, 0.2], 0.4, 0.7, 1),
    d5: pulled("fern", [0.25, -0.05], 0.5),
    d6: pulled("dragon-3", [0.2, 0.2], 0.8),
    d53: turned("sponge", 0.5),
    c1: row(rough([0, 0.6, 0], 0.2), rough([0, 0.6, 0], 0.4), rough([0, 0.6, 0], 0.6)),
    c24: row(
      plane([
        [0.5, 0.45, 0.45, -0.5, 0, 0],
        [0.5, -0.45, -0.45, -0.5, 0.5, 0.45],
      ]),
    ),
    c2: row(rough([0, 0.7, 0.2], 0.55)),
    ct2: row(rough([0, 0.5, 0.1], 0.7)),
    c3: row(
      { ...solid("tetrahedron"), turn: 0.3 },
      ...[0.4, 0.9].map((x) => plane(space.projectExactly(of("tetrahedron"), [x, 0.5, 0.8]))),
    ),
    c4: row(rough([0, 0.8, 0.3, 0.9, 0], 0.35)),
    c5: row(...[0.3, 0.45, 0.6, 0.75].map((d) => rough([0, 0.5, 0.2, 0.4], d))),
    c6: row(rough([0, 0.5, 0.3, 0.9, 0.4, 0.7, 0.2, 0], 0.3)),
    c7: one("tree"),
    c43: row(plane(shape("tree").maps), plane(shape("tree").maps)),
    s1: turned("triangle", 0.4),
    s2: turned("triangle", 0, 0.7, 1.4),
    s3: turned("triangle", 2.2),
    s4: turned("triangle", 2.8, 3.5),
    s5: turned("pyramid", 0.5),
    s6: turned("pyramid", 0, 1),
    s7: turned("fern", 0.5),
    s8: turned("tree", 0, 1),
    s34: row(plane(shape("fern").maps), plane(moved(shape("fern"), [0.75, 0.72, -0.4, 0.7, 0, 0]))),
    s35: row({ ...solid("dust"), turn: 0.5 }, plane(space.projectExactly(of("dust"), [0.3, 0.2, 1]))),
    s9: row(
      { solid: [{ maps: meet?.first ?? [] }], turn: 0.5 },
      { solid: [{ maps: meet?.second ?? [] }], turn: 0.5 },
    ),
    s10: row(plane(shape("twindragon").maps), plane(shape("twindragon").maps)),
    e1: row(corners(0.46), corners(0.49)),
    e2: row(triangle(0.5)),
    e3: one("pentagon"),
    e4: row(corners(0.3), corners(0.4)),
    e5: row(morph("koch", "dragon", 0.35)),
    e6: row(...[0.25, 0.5, 0.75].map((t) => morph("koch", "twindragon", t, t, true))),
    e7: led(LED.slice(1, 4)),
    e8: polygon(2, [0.5, 0.5], [0.6, 0.3], [0.4, 0.6], [0.3, 0.55]),
    e9: polygon(3, [0.5, 0.1], [0.4, 0.3], [0.3, 0.4]),
    e10: row(...TIMES.slice(1, 4).map((t) => plane(between(shape("fern"), reversed(shape("tree")), t, t)))),
    e12: row(...[1, 2, 3].map(() => plane(shape("gasket").maps))),
    e13: row(plane(shape("fern").maps.slice(1)), plane(shape("fern").maps)),
    e14: row(triangle(0.35), triangle(0.45), triangle(0.55)),
    e16: row(triangle(0.5), plane(shape("gasket").maps.slice(0, 2))),
    e17: row(plane(shape("gasket").maps), plane(shape("carpet").maps)),
    e18: row(rough([0, 0.7, 0.3, 0.9, 0.2], 0.25), rough([0, 0.7, 0.3, 0.9, 0.2], 0.5)),
    e29: row(...[0.25, 0.5, 0.7].map((s) => rough([0, 1, 0], s))),
    e15: one("fern"),
    e11: pulled("gasket", [0.3, 0.2], 0, 1.2),
    e20: row(morph("dragon-3", "gasket", 0.5), morph("dragon-3", "gasket", 0.5, 1.75)),
    e23: one("maple"),
    e27: row(plane(shape("maple").maps), plane(shape("fern").maps)),
    e28: row({ ...solid("tetrahedron"), turn: 0.4 }),
    e25: polygon(2, [0.276, 0.621], [0.21, 0.647], [0.141, 0.665], [0.047, 0.678]),
    e26: polygon(2, [0.019, 0.55], [0.022, 0.64], [0.5, 0.5]),
    e24: row({ ...solid("sponge"), turn: 0.4 }, plane(space.projectExactly(of("sponge"), [0, 1, 0]))),
    e21: row(polygon(2, [0.0227, 0.703]).cells[0] as Cell, morph("dragon-3", "gasket", 0.5, 1.75)),
    e22: pulled("gasket", [0.3, 0.2], 0.2, 0.6),
    e31: row(triangle(0.5), plane(shape("gasket").maps.slice(1))),
    e30: row(triangle(0.4), plane(triangleOf(0.4).map(([a = 0, , ...rest]) => [a, 0.4, ...rest]))),
  };
}

const reversed = (shape: Shape): Shape => ({ ...shape, maps: shape.maps.toReversed() });
