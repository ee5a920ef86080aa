/**
 * The photographs of two leaves on the curve between them: each point inside it is carried to where it lies in either
 * leaf, by mean value coordinates of places that are the same along all three curves, and one colour fades into the
 * other.
 */
import type { CurveMorph } from "#document/curve/curve";
import { cutOut } from "#document/curve/cut-out";
import type { CurvePhotograph, Photographs } from "#document/curve/photographs";
import { carry } from "#geometry/mean-value";
import { type Place, placesOf, ringAt, type Traced } from "./rings";
import { filled, type Texture } from "./texture";

/** How fine outlines are followed, in parts of their size. */
const TOLERANCE = 1 / 800;
/**
 * Places along a curve, cells of a side in which points are carried, and pixels of a side of what is made: photographs
 * have no more.
 */
const PLACES = 240;
const CELLS = 72;
const PIXELS = 640;

/** How wide the rim of a leaf is, in parts of its picture. */
const RIM = 0.02;

/** A picture, and the box of the plane that it lies on: left, bottom, right, top. */
export interface CarriedPicture {
  canvas: OffscreenCanvas;
  box: readonly [number, number, number, number];
}

export class Carried {
  readonly #morph: CurveMorph;
  readonly #edges: number;
  readonly #places: readonly Place[];
  readonly #rings: readonly [Float64Array, Float64Array];
  readonly #textures: readonly [Texture, Texture];
  #made: (CarriedPicture & { s: number; coarse: number }) | null = null;

  constructor(morph: CurveMorph, { a, b }: Photographs) {
    this.#morph = morph;
    this.#edges = morph.arcs().length / 4;
    const [first, last] = [this.#trace(0), this.#trace(1)];
    this.#places = placesOf([first, last], this.#edges, PLACES);
    this.#rings = [ringAt(first, this.#edges, this.#places), ringAt(last, this.#edges, this.#places)];
    this.#textures = [textureOf(a, first), textureOf(b, last)];
  }

  /** The picture at a moment, `coarse` times less fine than it could be. */
  at(s: number, coarse: number): CarriedPicture {
    if (this.#made?.s === s && this.#made.coarse === coarse) return this.#made;
    const traced = this.#trace(s);
    const ring = ringAt(traced, this.#edges, this.#places);
    const box = boxOf(traced.points);
    const [across, up] = [box[2] - box[0], box[3] - box[1]];
    const size = Math.max(across, up, 1e-12);
    const side = (length: number, most: number) => Math.max(2, Math.round((most * length) / size / coarse));
    const grid = gridOf(ring, this.#rings, box, size, side(across, CELLS), side(up, CELLS));
    const [width, height] = [side(across, PIXELS), side(up, PIXELS)];
    const canvas = this.#made?.canvas ?? new OffscreenCanvas(width, height);
    [canvas.width, canvas.height] = [width, height];
    const pixels = new ImageData(width, height);
    paintGrid(pixels, grid, this.#textures, s);
    canvas.getContext("2d")?.putImageData(pixels, 0, 0);
    this.#made = { s, coarse, canvas, box };
    return this.#made;
  }

  #trace(s: number): Traced {
    const [x0, y0, x1, y1] = this.#morph.bounds(s);
    const points = this.#morph.polyline(s, { tolerance: TOLERANCE * Math.max(x1 - x0, y1 - y0) });
    return { points, edges: this.#morph.edges() };
  }
}

/** What lies in curves of a morph in place of colours; null where there is nothing, or no canvas for it. */
export function carriedOn(morph: CurveMorph | null, photographs: Photographs | null): Carried | null {
  if (!morph || !photographs) return null;
  try {
    return new Carried(morph, photographs);
  } catch {
    // The curve is shown.
    return null;
  }
}

function textureOf({ image, box }: CurvePhotograph, { points }: Traced): Texture {
  const { data, width, height } = cutOut(image, box, points);
  // Where the curve strays from the leaf there is ground along it.
  const core = cutOut(image, box, points, RIM * Math.max(width, height));
  return { data: filled(core, data), width, height, box };
}

function boxOf(points: Float64Array): [number, number, number, number] {
  const box: [number, number, number, number] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i + 1 < points.length; i += 2) {
    box[0] = Math.min(box[0], points[i] ?? 0);
    box[1] = Math.min(box[1], points[i + 1] ?? 0);
    box[2] = Math.max(box[2], points[i] ?? 0);
    box[3] = Math.max(box[3], points[i + 1] ?? 0);
  }
  return box;
}

/** Where the corners of cells lie in either leaf: four numbers a corner, row after row from the top. */
export interface Grid {
  columns: number;
  rows: number;
  at: Float64Array;
}

export function gridOf(
  ring: Float64Array,
  to: readonly Float64Array[],
  [x0, y0, x1, y1]: readonly [number, number, number, number],
  size: number,
  columns: number,
  rows: number,
): Grid {
  const at = new Float64Array(4 * (columns + 1) * (rows + 1));
  for (let row = 0, i = 0; row <= rows; row++) {
    for (let column = 0; column <= columns; column++, i += 4) {
      const x = x0 + ((x1 - x0) * column) / columns;
      const y = y1 - ((y1 - y0) * row) / rows;
      carry(ring, to, size, x, y, at.subarray(i, i + 4));
    }
  }
  return { columns, rows, at };
}

/** Mixes both pictures, `s` of the second, where the grid says. */
export function paintGrid(
  { data, width, height }: ImageData,
  { columns, rows, at }: Grid,
  [first, second]: readonly [Texture, Texture],
  s: number,
): void {
  const colour = new Float64Array(3);
  const line = new Float64Array(4 * (columns + 1));
  for (let y = 0, i = 0; y < height; y++) {
    const down = ((y + 0.5) / height) * rows;
    const row = Math.min(rows - 1, Math.floor(down));
    const v = down - row;
    const above = 4 * row * (columns + 1);
    for (let k = 0; k < line.length; k++) {
      line[k] = (at[above + k] ?? 0) * (1 - v) + (at[above + line.length + k] ?? 0) * v;
    }
    for (let x = 0; x < width; x++, i += 4) {
      const along = ((x + 0.5) / width) * columns;
      const column = Math.min(columns - 1, Math.floor(along));
      const u = along - column;
      const place = (k: number) =>
        (line[4 * column + k] ?? 0) * (1 - u) + (line[4 * column + 4 + k] ?? 0) * u;
      colour.fill(0);
      if (s < 1) look(first, place(0), place(1), 1 - s, colour);
      if (s > 0) look(second, place(2), place(3), s, colour);
      for (let k = 0; k < 3; k++) data[i + k] = colour[k] ?? 0;
      data[i + 3] = 255;
    }
  }
}

/** Adds a part of the colour at a point of the plane, between four pixels; beyond the picture that of its edge. */
function look(
  { data, width, height, box: [x0, y0, x1, y1] }: Texture,
  x: number,
  y: number,
  part: number,
  colour: Float64Array,
): void {
  const across = within(((x - x0) / (x1 - x0)) * width - 0.5, width - 1);
  const down = within(((y1 - y) / (y1 - y0)) * height - 0.5, height - 1);
  const [left, top] = [Math.floor(across), Math.floor(down)];
  const [u, v] = [across - left, down - top];
  const i = 4 * (top * width + left);
  const right = left + 1 < width ? 4 : 0;
  const below = top + 1 < height ? 4 * width : 0;
  for (let k = 0; k < 3; k++) {
    const upper = (data[i + k] ?? 0) * (1 - u) + (data[i + right + k] ?? 0) * u;
    const lower = (data[i + below + k] ?? 0) * (1 - u) + (data[i + below + right + k] ?? 0) * u;
    colour[k] = (colour[k] ?? 0) + part * (upper * (1 - v) + lower * v);
  }
}

/** From 0 to `most`; what is no number is 0. */
const within = (x: number, most: number): number => (x > 0 ? Math.min(most, x) : 0);
