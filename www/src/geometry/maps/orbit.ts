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
  /** Whether none is nearer, but for a thousandth; else it is the nearest that was found. */
  sure: boolean;
}

/** A piece of a piece .. of the shape. */
interface Node {
  /** The piece that it is a part of, and the last letter of its address. */
  parent: Node | null;
  letter: number;
  depth: number;
  map: MapRow;
  /** No point of it is nearer than this. */
  least: number;
  /** Its place among all that were looked at. */
  order: number;
}

/** A piece that is so small, in sizes of the whole, is a point. */
const FINE = 1e-12;
/** Of a point off the shape the distance has to be known to so much of it only. */
const ROUGH = 1e-3;
/** Pieces looked at, at most: where many overlap a point lies in a great many of them. */
const BUDGET = 12_000;
/** Letters that an address has at least: it goes on with the first map for ever. */
const LETTERS = 24;

/**
 * The point of the shape that is nearest to a point; null where none is `within`. The box has to hold the shape. Pieces
 * are taken apart in the order of how near they may be; among equals the longer address goes first, and then the lower
 * letter, so that a point of several addresses gets the first of them.
 */
export function nearestOn(
  maps: readonly MapRow[],
  box: Box,
  point: Point,
  { within = Number.POSITIVE_INFINITY, first }: { within?: number; first?: number } = {},
): Nearest | null {
  const corners: readonly Point[] = [
    [box.x0, box.y0],
    [box.x1, box.y0],
    [box.x1, box.y1],
    [box.x0, box.y1],
  ];
  const size = Math.max(Math.hypot(box.x1 - box.x0, box.y1 - box.y0), Number.MIN_VALUE);
  const anchor = anchorOf(maps);
  const apart = ([x, y]: Point) => Math.hypot(x - point[0], y - point[1]);
  let looked = 0;
  let best: Node | null = null;
  let upper = Number.POSITIVE_INFINITY;
  const nodeOf = (parent: Node | null, letter: number, map: MapRow): Node => {
    const least = Math.max(0, awayFrom(map, corners, point) - FINE * size);
    const node = { parent, letter, depth: parent ? parent.depth + 1 : 0, map, least, order: looked++ };
    const distance = apart(imageOf(map, anchor));
    if (distance < upper) [best, upper] = [node, distance];
    return node;
  };
  const root = nodeOf(null, -1, STILL);
  if (first !== undefined) upper = Number.POSITIVE_INFINITY;
  const open = [first === undefined ? root : nodeOf(root, first, maps[first] ?? STILL)];
  while (looked < BUDGET) {
    const here = take(open);
    if (!here || here.least > within) return null;
    if (best && here.least > 0 && upper - here.least <= ROUGH * here.least) return found(best, upper, true);
    // So small that its own point is the one.
    if (lengthens(here.map) * size <= FINE * size) return found(here, apart(imageOf(here.map, anchor)), true);
    // The last one is put in first: among equals the latest is taken.
    for (let letter = maps.length - 1; letter >= 0; letter--) {
      const map = maps[letter];
      if (map) put(open, nodeOf(here, letter, after2(here.map, map)));
    }
  }
  return best ? found(best, upper, false) : null;
}

function found(node: Node, distance: number, sure: boolean): Nearest {
  const address: number[] = [];
  for (let at: Node | null = node; at && at.letter >= 0; at = at.parent) address.push(at.letter);
  address.reverse();
  while (address.length < LETTERS) address.push(0);
  return { address, distance, sure };
}

/** How far a point is from the image of a convex polygon. */
function awayFrom(map: MapRow, corners: readonly Point[], [x, y]: Point): number {
  const placed = corners.map((corner) => imageOf(map, corner));
  let least = Number.POSITIVE_INFINITY;
  let [left, right] = [false, false];
  for (const [i, [x0, y0]] of placed.entries()) {
    const [x1, y1] = placed[(i + 1) % placed.length] ?? [x0, y0];
    const [dx, dy] = [x1 - x0, y1 - y0];
    const [px, py] = [x - x0, y - y0];
    const side = dx * py - dy * px;
    if (side > 0) left = true;
    if (side < 0) right = true;
    const long = dx * dx + dy * dy;
    const along = long > 0 ? Math.min(1, Math.max(0, (px * dx + py * dy) / long)) : 0;
    least = Math.min(least, Math.hypot(px - along * dx, py - along * dy));
  }
  // All edges on one side: it is inside. A flat one has no inside.
  return left !== right ? 0 : least;
}

/** Whether a piece is to be looked at before another. */
const isBefore = (p: Node, q: Node): boolean =>
  p.least !== q.least ? p.least < q.least : p.depth !== q.depth ? p.depth > q.depth : p.order > q.order;

/** Into a heap. */
function put(open: Node[], node: Node): void {
  let at = open.length;
  open.push(node);
  while (at > 0) {
    const above = (at - 1) >> 1;
    const parent = open[above] as Node;
    if (!isBefore(node, parent)) break;
    open[at] = parent;
    at = above;
  }
  open[at] = node;
}

/** The first of a heap. */
function take(open: Node[]): Node | undefined {
  const first = open[0];
  const last = open.pop();
  if (!last || open.length === 0) return first;
  let at = 0;
  for (;;) {
    const left = open[2 * at + 1];
    const right = open[2 * at + 2];
    const next = right && left && isBefore(right, left) ? right : left;
    if (!next || !isBefore(next, last)) break;
    open[at] = next;
    at = next === left ? 2 * at + 1 : 2 * at + 2;
  }
  open[at] = last;
  return first;
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
