/** Pictures that the program makes of its own shapes while the site is built. */
import { readFileSync } from "node:fs";
import { deflateSync } from "node:zlib";
import type { Bend, MapRow, MapRow3 } from "../../crate/web/src/api";
import { NIGHT } from "../src/style/colours.ts";
import { channelsOf } from "../src/style/hex.ts";
import { palette } from "../src/style/palette.ts";
import { chunkBytes, PNG_SIGNATURE } from "../src/workers/image/png.ts";

export interface Shape {
  id: string;
  name: string;
  about: string;
  maps: number[][];
}

/** A shape of the plane, bent or not; or of space, seen from so far to the side, in radians. */
export type Cell = { maps: MapRow[]; bend?: Bend } | { solid: { maps: MapRow3[] }[]; turn?: number };

/** What pictures are made of. */
export interface Source {
  shape(id: string): Shape;
  /** A moment of the ways from one shape to another. */
  between(a: Shape, b: Shape, u: number, v?: number, linear?: boolean): number[][];
  /** The same shape elsewhere: its maps, conjugated. */
  moved(shape: Shape, by: MapRow): number[][];
  family(sides: number, s: [re: number, im: number]): number[][];
  bounds(maps: number[][]): { min: [number, number]; max: [number, number] };
  /** A shape of space. */
  solid(id: string): { solid: { maps: MapRow3[] }[] };
  space: Pick<Module3, "meetExamples" | "projectExactly">;
}

export interface Drawer extends Source {
  /** The gallery. */
  shapes(): Shape[];
  /**
   * Shapes on a dark ground, side by side or in rows, as a PNG; `free` is how much of the shorter side of its place is
   * free around each.
   */
  picture(
    cells: readonly Cell[],
    size: { width: number; height: number },
    free: number,
    columns?: number,
  ): Uint8Array;
}

type Module = typeof import("../pkg/frond.js");
type Module3 = typeof import("../pkg/frond-space.js");

/** What draws. The modules are there when the site is built, and need not be before. */
export async function drawer(): Promise<Drawer> {
  const load = async <M extends Module | Module3>(name: string): Promise<M> => {
    const here: string = new URL(`../pkg/${name}.js`, import.meta.url).href;
    const module: M = await import(/* @vite-ignore */ here);
    module.initSync({ module: readFileSync(new URL(`../pkg/${name}_bg.wasm`, import.meta.url)) });
    return module;
  };
  const plane = await load<Module>("frond");
  const space = await load<Module3>("frond-space");
  const shapes = plane.presets() as unknown as Shape[];
  const solids = space.presets3();
  const named = <T extends { id: string }>(all: readonly T[], id: string): T => {
    const found = all.find((one) => one.id === id);
    if (!found) throw new Error(`there is no shape ${id}`);
    return found;
  };
  const rows = (maps: number[][]) => ({ maps: maps as MapRow[] });
  return {
    shapes: () => shapes,
    shape: (id) => named(shapes, id),
    between: (a, b, u, v = u, linear = false) => {
      const { from, to } = plane.pair(rows(a.maps), rows(b.maps));
      const mode = linear ? "linear" : "polar";
      return plane.interpolate({ maps: from }, { maps: to }, { u, v, mode }).maps;
    },
    moved: ({ maps }, by) => plane.conjugate(rows(maps), by).maps,
    family: (sides, s) => plane.familyMaps({ sides }, s).maps,
    bounds: (maps) => plane.bounds(rows(maps)),
    solid: (id) => ({ solid: [{ maps: named(solids, id).maps }] }),
    space,
    picture: (cells, { width, height }, free, columns = cells.length) => {
      const canvas = new Canvas(width, height);
      const [across, down] = [width / columns, height / Math.ceil(cells.length / columns)].map(
        Math.floor,
      ) as [number, number];
      for (const [i, cell] of cells.entries()) {
        const pixels =
          "solid" in cell ? drawSolid(space, cell, across, down) : drawPlane(plane, cell, across, down, free);
        canvas.lay(pixels, across, (i % columns) * across, Math.floor(i / columns) * down);
      }
      return canvas.png();
    },
  };
}

function drawPlane(
  frond: Module,
  { maps, bend }: Extract<Cell, { maps: unknown }>,
  width: number,
  height: number,
  free: number,
): Uint8ClampedArray {
  const { min, max } = frond.bounds({ maps });
  const margin = 2 * free * Math.min(width, height);
  const scale = Math.min(
    (width - margin) / (max[0] - min[0] || 1),
    (height - margin) / (max[1] - min[1] || 1),
  );
  const view = { x: (min[0] + max[0]) / 2, y: (min[1] + max[1]) / 2, scale };
  const options = { width, height, view, palette: palette("dark") };
  return frond.rasterize({ maps }, bend ? { ...options, bend } : options);
}

/** Units of work at a time. */
const WORK = 1 << 20;

function drawSolid(
  frond: Module3,
  { solid, turn = 0 }: Extract<Cell, { solid: unknown }>,
  width: number,
  height: number,
): Uint8ClampedArray {
  const scene = frond.defaultSpace();
  const objects = solid.map(({ maps }) => ({ name: "", maps }));
  const seen = frond.defaultView({ ...scene, objects });
  // From further away where a place is narrow.
  const view = { ...seen, turn, distance: seen.distance * Math.max(1, height / width) };
  const drawn = new frond.SpacePicture(objects);
  const carve = drawn.carve(view, width, height);
  while (!carve.run(WORK));
  const look = { width, height, factor: 1, palette: palette("dark"), ground: NIGHT };
  const pixels = carve.paint(scene.light, look);
  carve.free();
  drawn.free();
  return new Uint8ClampedArray(pixels);
}

/** A picture in the making, on the ground of the night. */
class Canvas {
  readonly #width: number;
  readonly #height: number;
  /** A row begins with the number of its filter: none. */
  readonly #rows: Uint8Array;

  constructor(width: number, height: number) {
    this.#width = width;
    this.#height = height;
    this.#rows = new Uint8Array(height * (3 * width + 1));
    const ground = channelsOf(NIGHT);
    for (let y = 0; y < height; y++) {
      for (let x = 0; x < width; x++) this.#rows.set(ground, this.#at(x, y));
    }
  }

  #at(x: number, y: number): number {
    return y * (3 * this.#width + 1) + 1 + 3 * x;
  }

  lay(pixels: Uint8ClampedArray, width: number, left: number, top: number): void {
    const rows = this.#rows;
    for (let from = 0; from < pixels.length; from += 4) {
      const alpha = (pixels[from + 3] ?? 0) / 255;
      if (alpha === 0) continue;
      const to = this.#at(left + ((from / 4) % width), top + Math.floor(from / 4 / width));
      for (let i = 0; i < 3; i++)
        rows[to + i] = Math.round((pixels[from + i] ?? 0) * alpha + (rows[to + i] ?? 0) * (1 - alpha));
    }
  }

  png(): Uint8Array {
    const head = new Uint8Array(13);
    new DataView(head.buffer).setUint32(0, this.#width);
    new DataView(head.buffer).setUint32(4, this.#height);
    // Eight bits of red, green and blue.
    head.set([8, 2], 8);
    return Buffer.concat([
      Uint8Array.from(PNG_SIGNATURE),
      chunkBytes({ type: "IHDR", data: head }),
      chunkBytes({ type: "IDAT", data: deflateSync(this.#rows) }),
      chunkBytes({ type: "IEND", data: new Uint8Array() }),
    ]);
  }
}
