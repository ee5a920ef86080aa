/** A game of throws: a cell of a shape is to be reached by choosing maps, in as few as can be. */
import type { MapRow } from "#wasm/api";
import * as messages from "../messages";
import { imageOf } from "./affine2";
import { anchorOf, hash, isInvertible, type Point, pieceMap, preimageOf } from "./orbit";

/** What is played on: the maps, a polygon that holds the shape, and where the point begins. */
export interface Board {
  maps: readonly MapRow[];
  hull: readonly Point[];
  start: Point;
}

/** A cell that is deeper is too small to be seen. */
export const DEEPEST = 5;
/** Beyond so many maps there are more ways than can be tried. */
export const MOST_PLAYED = 9;
const SAMPLES = 4000;
const FORGET = 50;

/** Why this is not played with these maps, in a sentence; null where it is. */
export function unplayable(maps: readonly MapRow[]): string | null {
  if (maps.length < 2) return messages.targetNeedsTwoMaps;
  if (maps.length > MOST_PLAYED) return messages.targetTooManyMaps(maps.length, MOST_PLAYED);
  const flat = maps.findIndex((map) => !isInvertible(map));
  if (flat >= 0) return messages.targetIsFlat(flat + 1);
  return null;
}

/** A convex polygon around a shape, by many points of it; counter-clockwise. */
export function hullOf(maps: readonly MapRow[]): Point[] {
  let here = anchorOf(maps);
  // The points that single maps keep in place are often corners, which chance seldom comes to.
  const points = maps.map((map) => anchorOf([map]));
  for (let i = 0; i < SAMPLES + FORGET; i++) {
    const map = maps[hash(i) % Math.max(1, maps.length)];
    if (map) here = imageOf(map, here);
    if (i >= FORGET && here.every(Number.isFinite)) points.push(here);
  }
  return convex(points);
}

/** The convex hull (Andrew's monotone chain). */
function convex(points: readonly Point[]): Point[] {
  const sorted = [...points].sort(([x, y], [u, v]) => x - u || y - v);
  const side = ([ox, oy]: Point, [ax, ay]: Point, [bx, by]: Point) =>
    (ax - ox) * (by - oy) - (ay - oy) * (bx - ox);
  const chain = (all: readonly Point[]) => {
    const kept: Point[] = [];
    for (const point of all) {
      while (kept.length >= 2 && side(kept.at(-2) as Point, kept.at(-1) as Point, point) <= 1e-12) kept.pop();
      kept.push(point);
    }
    return kept.slice(0, -1);
  };
  return [...chain(sorted), ...chain(sorted.toReversed())];
}

/** The middle of a polygon's corners. */
export function middleOf(hull: readonly Point[]): Point {
  const count = Math.max(1, hull.length);
  return [hull.reduce((sum, [x]) => sum + x, 0) / count, hull.reduce((sum, [, y]) => sum + y, 0) / count];
}

/** The corners of a cell. */
export function cellOf({ maps, hull }: Board, address: readonly number[]): Point[] {
  const map = pieceMap(maps, address);
  return hull.map((corner) => imageOf(map, corner));
}

/** Whether a point lies in a cell, its edge included. */
export function isIn({ maps, hull }: Board, address: readonly number[], point: Point): boolean {
  const back = address.reduce<Point | null>((at, letter) => {
    const map = maps[letter];
    return at && map ? preimageOf(map, at) : null;
  }, point);
  if (!back || hull.length < 3) return false;
  const [x, y] = back;
  const size = Math.max(...hull.map(([u, v]) => Math.hypot(u - x, v - y)));
  return hull.every(([x0, y0], i) => {
    const [x1, y1] = hull[(i + 1) % hull.length] ?? [x0, y0];
    return (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0) >= -1e-9 * size * Math.hypot(x1 - x0, y1 - y0);
  });
}

/** The fewest maps that lead from the start into a cell, the first one first. */
export function fewest(board: Board, address: readonly number[]): number[] {
  let ways: { letters: number[]; at: Point }[] = [{ letters: [], at: board.start }];
  for (let length = 0; length < address.length; length++) {
    const there = ways.find(({ at }) => isIn(board, address, at));
    if (there) return there.letters;
    ways = ways.flatMap(({ letters, at }) =>
      board.maps.map((map, letter) => ({ letters: [...letters, letter], at: imageOf(map, at) })),
    );
  }
  // Its own letters lead there from anywhere in the polygon, the last one first.
  return [...address].reverse();
}

/** A cell of so many letters that the start is not in, the same for the same seed. */
export function newTarget(board: Board, length: number, seed: number): number[] {
  const count = board.maps.length;
  let found: number[] = [];
  for (let tries = 0; tries < 50; tries++) {
    found = Array.from({ length }, (_, i) => hash(hash(seed) + 64 * tries + i) % count);
    if (!isIn(board, found, board.start)) return found;
  }
  return found;
}
