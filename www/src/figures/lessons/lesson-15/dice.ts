/** The chaos game with dice of uneven chances, and where its marks lie. */
import { hash } from "#geometry/maps/orbit";
import type { MapRow } from "#wasm/api";
import { determinant, fixedPoint } from "../../kit/maps/families";
import { apply } from "../../kit/maps/pieces";

export interface Game {
  /** x0, y0, x1, y1, .. */
  points: Float64Array;
  /** The map that was thrown for each of them. */
  maps: Uint8Array;
}

/** Weights as chances: they sum to 1. */
export function chances(weights: readonly number[]): number[] {
  const sum = weights.reduce((all, weight) => all + weight, 0);
  return weights.map((weight) => weight / sum);
}

/** The least share of a piece without an area: a stem is a line. */
const LEAST = 0.01;

/** Chances by the areas of the pieces. */
export function byArea(maps: readonly MapRow[]): number[] {
  const areas = maps.map((map) => Math.abs(determinant(map)));
  const all = areas.reduce((sum, area) => sum + area, 0);
  return chances(areas.map((area) => Math.max(area, LEAST * all)));
}

/** So many throws from a point of the shape, so that all marks lie on it; the same at every try. */
export function play(maps: readonly MapRow[], weights: readonly number[], count: number): Game {
  const points = new Float64Array(2 * count);
  const thrown = new Uint8Array(count);
  let below = 0;
  const steps = chances(weights).map((chance) => {
    below += chance;
    return below * 2 ** 32;
  });
  let here = fixedPoint(maps[0] ?? [0, 0, 0, 0, 0, 0]);
  for (let i = 0; i < count; i++) {
    const face = hash(i);
    const found = steps.findIndex((step) => face < step);
    // The sum of all chances may round to a little below 1.
    const k = found < 0 ? maps.length - 1 : found;
    const map = maps[k];
    if (map) here = apply(map, here);
    points[2 * i] = here[0];
    points[2 * i + 1] = here[1];
    thrown[i] = k;
  }
  return { points, maps: thrown };
}

/** How many marks were made in the piece with this address: the last throw is its first letter. */
export function marksIn({ maps }: Game, address: readonly number[]): number {
  let count = 0;
  for (let i = address.length - 1; i < maps.length; i++)
    if (address.every((letter, k) => maps[i - k] === letter)) count++;
  return count;
}

/** The share of all marks that such a piece gets in the long run, where pieces have no more than edges in common. */
export function share(weights: readonly number[], address: readonly number[]): number {
  const each = chances(weights);
  return address.reduce((product, letter) => product * (each[letter] ?? 0), 1);
}

interface Cells {
  columns: number;
  rows: number;
  /** The plane in the middle of the cells, and how many of them make a unit. */
  view: { x: number; y: number; scale: number };
}

/** How many marks lie in each cell, row by row from the top; those beyond are left out. */
export function tally({ points }: Game, { columns, rows, view }: Cells): Uint32Array {
  const found = new Uint32Array(columns * rows);
  for (let i = 0; i + 1 < points.length; i += 2) {
    const column = Math.floor(columns / 2 + ((points[i] ?? 0) - view.x) * view.scale);
    const row = Math.floor(rows / 2 - ((points[i + 1] ?? 0) - view.y) * view.scale);
    if (column < 0 || column >= columns || row < 0 || row >= rows) continue;
    const at = row * columns + column;
    found[at] = (found[at] ?? 0) + 1;
  }
  return found;
}

/** How strong the colour of each cell is, 0 to 1: about half for as many marks as a cell in use has on average. */
export function shades(tallied: Uint32Array): Float32Array {
  let [used, marks] = [0, 0];
  for (const count of tallied) {
    if (count > 0) used++;
    marks += count;
  }
  const mean = marks / Math.max(1, used);
  return Float32Array.from(tallied, (count) =>
    count === 0 ? 0 : FAINT + ((1 - FAINT) * count) / (count + mean),
  );
}

/** One mark is seen, however many there are elsewhere. */
const FAINT = 0.3;
