/** A leaf covered with copies of itself: how well, what their maps make, and what is known of that beforehand. */
import type { MapRow } from "#wasm/api";
import { norm, type Point } from "../../kit/maps/pieces";
import { type Field, list, number } from "../../kit/state/fields";
import { byArea, play } from "../lesson-15/dice";
import { CENTRE, inLeaf } from "./leaf";
import { hausdorff, imageOf, type Raster, rasterOf, rasterOfPoints, type Worst } from "./raster";

/** A copy of the leaf: where its middle is, how long it is, how wide for its length, and how far it is turned. */
export interface Copy {
  at: Point;
  size: number;
  /** 1 where its form is that of the leaf. */
  width: number;
  /** In degrees, counter-clockwise. */
  turn: number;
}

/** Within these the copies stay on the grid: the leaf reaches 0.61 from its middle. */
export const SIZES = [0.15, 0.75] as const;
export const WIDTHS = [0.3, 1] as const;
export const ACROSS = [-0.6, 0.6] as const;
export const UP = [0, 1] as const;
export const [FEWEST, MOST] = [3, 5];

/** First narrowed, then made smaller, turned and moved, all about the middle of the leaf. */
export function mapOf({ at, size, width, turn }: Copy): MapRow {
  const angle = (turn * Math.PI) / 180;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const [a, b, c, d] = [size * width * cos, -size * sin, size * width * sin, size * cos];
  const [x, y] = CENTRE;
  return [a, b, c, d, at[0] - a * x - b * y, at[1] - c * x - d * y];
}

const NUMBERS = list(number(-180, 180, 3), 5, 5, ":");

/** As it stands in the address of the lesson. */
export const COPY: Field<Copy> = {
  write: ({ at, size, width, turn }) => NUMBERS.write([...at, size, width, turn]),
  read(text) {
    const [x, y, size, width, turn] = NUMBERS.read(text) ?? [];
    if (x === undefined || y === undefined || size === undefined || width === undefined) return null;
    return tame({ at: [x, y], size, width, turn: turn ?? 0 });
  },
};

/** The factor by which all maps shrink at least. */
export function contraction(maps: readonly MapRow[]): number {
  return Math.max(...maps.map(norm));
}

/** Barnsley's bound for the distance of leaf and attractor. */
export function bound(collage: number, s: number): number {
  return s < 1 ? collage / (1 - s) : Number.POSITIVE_INFINITY;
}

/** The marks by which the attractor is known. */
const MARKS = 50_000;

let leaf: Raster | null = null;
/** The cells of the leaf. */
export function leafRaster(): Raster {
  leaf ??= rasterOf(inLeaf);
  return leaf;
}

/** How far the copies together are from the leaf. */
export function collageWorst(maps: readonly MapRow[]): Worst | null {
  return hausdorff(leafRaster(), imageOf(leafRaster(), maps));
}

/** How far what the maps make is from the leaf, by so many points of it; null where it leaves the grid. */
export function attractorWorst(maps: readonly MapRow[]): Worst | null {
  const raster = rasterOfPoints(play(maps, byArea(maps), MARKS).points);
  return raster && hausdorff(leafRaster(), raster);
}

const within = ([min, max]: readonly [number, number], x: number) => Math.min(max, Math.max(min, x));
const short = (x: number) => Math.round(x * 1000) / 1000;

/** A copy within what is allowed, in round numbers. */
export function tame({ at: [x, y], size, width, turn }: Copy): Copy {
  const turned = ((((turn + 180) % 360) + 360) % 360) - 180;
  return {
    at: [short(within(ACROSS, x)), short(within(UP, y))],
    size: short(within(SIZES, size)),
    width: short(within(WIDTHS, width)),
    turn: Math.round(turned),
  };
}

/** How a player begins: four copies that lie about. */
export const START: readonly Copy[] = [
  { at: [0, 0.7], size: 0.5, width: 1, turn: 0 },
  { at: [-0.3, 0.4], size: 0.5, width: 1, turn: 0 },
  { at: [0.3, 0.4], size: 0.5, width: 1, turn: 0 },
  { at: [0, 0.3], size: 0.3, width: 1, turn: 180 },
];

/** A good one: three lobes and what is left in the middle. */
export const GOOD: readonly Copy[] = [
  { at: [0, 0.68], size: 0.6, width: 0.85, turn: 0 },
  { at: [-0.3, 0.35], size: 0.6, width: 0.95, turn: 60 },
  { at: [0.3, 0.35], size: 0.6, width: 0.95, turn: -60 },
  { at: [0, 0.4], size: 0.3, width: 1, turn: 0 },
];
