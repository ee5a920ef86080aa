/**
 * Orbits of a point under the maps of a shape, and the addresses of its points.
 *
 * Letters count from 0 here and from 1 where people read them. The address of a point names the piece that it lies in,
 * then the piece of that piece, and so on (Hutchinson 1981). So each map that is applied puts its letter in front.
 */
import type { MapRow } from "#wasm/api";
import type { Box } from "../boxes";
import { after2, determinant, imageOf } from "./affine2";

export type Point = [x: number, y: number];

/** A point and where it is after each of these maps, the first one applied first. A map that is missing ends it. */
export function orbitOf(maps: readonly MapRow[], start: Point, letters: readonly number[]): Point[] {
  const points = [start];
  let here = start;
  for (const letter of letters) {
    const map = maps[letter];
    if (!map) break;
    here = imageOf(map, here);
    points.push(here);
  }
  return points;
}

/** The address of where these maps lead, as far as they say it: the last one is the first letter. */
export function addressOf(letters: readonly number[]): number[] {
  return [...letters].reverse();
}

const STILL: MapRow = [1, 0, 0, 1, 0, 0];

/** The map that makes the piece with this address. */
export function pieceMap(maps: readonly MapRow[], address: readonly number[]): MapRow {
  return address.reduce((map, letter) => after2(map, maps[letter] ?? STILL), STILL);
}

/** Whether a map has an inverse that a number can hold. */
export function isInvertible(map: MapRow): boolean {
  return Math.abs(determinant(map)) > 1e-12;
}

/** Where a point comes from; null under a map that flattens the plane. */
export function preimageOf(map: MapRow, [x, y]: Point): Point | null {
  if (!isInvertible(map)) return null;
  const [a, b, c, d, e, f] = map;
  const det = determinant(map);
  const [u, v] = [x - e, y - f];
  return [(d * u - b * v) / det, (a * v - c * u) / det];
}

/** The point that the first map keeps in place: it is on the shape, whatever the other maps are. */
export function anchorOf(maps: readonly MapRow[]): Point {
  const [a, b, c, d, e, f] = maps[0] ?? STILL;
  const det = (1 - a) * (1 - d) - b * c;
  return Math.abs(det) < 1e-12 ? [e, f] : [((1 - d) * e + b * f) / det, (c * e + (1 - a) * f) / det];
}

/** The point of the shape whose address begins so and goes on with the first letter for ever. */
export function pointAt(maps: readonly MapRow[], address: readonly number[]): Point {
  return address.reduceRight<Point>((point, letter) => {
    const map = maps[letter];
    return map ? imageOf(map, point) : point;
  }, anchorOf(maps));
}

/** The nearest point of a shape, by its address, and how far it is. */
export interface Nearest {
  address: number[];
  distance: number;
}

interface Node {
  address: number[];
  map: MapRow;
  /** No point of the piece is nearer than this. */
  least: number;
  /** How far the piece reaches from the middle of its disc. */
  reach: number;
}

/** A piece that is so small, in sizes of the whole, is a point. */
const FINE = 1e-12;
/** Of a point off the shape the distance has to be known to so much of it only. */
const ROUGH = 1e-3;
/** Pieces looked at, at most: where many overlap a point lies in a great many of them. */
const BUDGET = 20_000;

/**
 * The point of the shape that is nearest to a point; null where the budget does not suffice. The box has to hold the
 * shape. Pieces are taken apart in the order of how near they may be; among equals the longer address goes first, and
 * then the lower letter, so that a point of several addresses gets the first of them.
 */
export function nearestOn(
  maps: readonly MapRow[],
  box: Box,
  point: Point,
  { within = Number.POSITIVE_INFINITY, first }: { within?: number; first?: number } = {},
): Nearest | null {
  const middle: Point = [(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2];
  const radius = Math.hypot(box.x1 - box.x0, box.y1 - box.y0) / 2;
  const size = Math.max(radius, Number.MIN_VALUE);
  const nodeOf = (address: number[], map: MapRow): Node => {
    const reach = lengthens(map) * radius;
    const [x, y] = imageOf(map, middle);
    return { address, map, reach, least: Math.max(0, Math.hypot(x - point[0], y - point[1]) - reach) };
  };
  const begin = first === undefined ? nodeOf([], STILL) : nodeOf([first], maps[first] ?? STILL);
  const open: Node[] = [begin];
  for (let looked = 0; looked < BUDGET; ) {
    const here = open.pop();
    if (!here || here.least > within) return null;
    if (here.reach <= Math.max(FINE * size, ROUGH * here.least)) {
      const [x, y] = pointAt(maps, here.address);
      return { address: here.address, distance: Math.hypot(x - point[0], y - point[1]) };
    }
    // The last one is put in first: among equals it is taken last.
    for (let letter = maps.length - 1; letter >= 0; letter--) {
      const map = maps[letter];
      if (!map) continue;
      looked++;
      put(open, nodeOf([...here.address, letter], after2(here.map, map)));
    }
  }
  return null;
}

/** Below 0 where one is to be looked at before another. */
const before = (p: Node, q: Node) => p.least - q.least || q.address.length - p.address.length;

/** In order, the next one last. Among equals what is put in later is taken first. */
function put(open: Node[], node: Node): void {
  let [low, high] = [0, open.length];
  while (low < high) {
    const half = (low + high) >> 1;
    if (before(open[half] as Node, node) >= 0) low = half + 1;
    else high = half;
  }
  open.splice(low, 0, node);
}

/** The most by which a map lengthens anything. */
function lengthens([a, b, c, d]: MapRow): number {
  const half = (a * a + b * b + c * c + d * d) / 2;
  const det = a * d - b * c;
  return Math.sqrt(half + Math.sqrt(Math.max(0, half * half - det * det)));
}

/** So near to a piece, in sizes of the whole, a point is in it: rounding is less. */
const IN = 1e-9;

/** The pieces that a point lies in, from 0. */
export function piecesAt(maps: readonly MapRow[], box: Box, point: Point): number[] {
  const within = IN * Math.max(Math.hypot(box.x1 - box.x0, box.y1 - box.y0), Number.MIN_VALUE);
  return [...maps.keys()].filter((first) => {
    const found = nearestOn(maps, box, point, { within, first });
    return found !== null && found.distance <= within;
  });
}

/** A number of 32 bits that looks random and is the same for the same `n`. */
export function hash(n: number): number {
  let x = n + 0x9e3779b9;
  x = Math.imul(x ^ (x >>> 16), 0x21f0aaad);
  x = Math.imul(x ^ (x >>> 15), 0x735a2d97);
  return (x ^ (x >>> 15)) >>> 0;
}

/** A map at random, by weights where there are some: `chance` is a number from 0 to 1. */
export function thrown(maps: number, chance: number, weights?: readonly number[]): number {
  const each = Array.from({ length: maps }, (_, i) => Math.max(0, weights?.[i] ?? (weights ? 0 : 1)));
  const sum = each.reduce((all, weight) => all + weight, 0);
  // Weights of nothing are no weights.
  if (!(sum > 0)) return Math.min(maps - 1, Math.floor(chance * maps));
  let left = chance * sum;
  const found = each.findIndex((weight) => {
    left -= weight;
    return left < 0;
  });
  return found < 0 ? each.findLastIndex((weight) => weight > 0) : found;
}
