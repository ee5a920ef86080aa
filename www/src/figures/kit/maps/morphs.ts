/** Morphs as the figures show them: frames at even times, and one box for all. */

import { type Box, boxOf, diagonal } from "#document/framing";
import { type Uv, uvAt } from "#geometry/path";
import type { MapRow, Mode } from "#wasm/api";
import { frond } from "#wasm/core";
import type { StripFrame } from "../picture/stills";
import { determinant } from "./families";

export interface Ends {
  from: MapRow[];
  to: MapRow[];
}

export const STRAIGHT: readonly Uv[] = [
  [0, 0],
  [1, 1],
];

/** The maps at a point of the (u, v) plane. */
export function mapsAt({ from, to }: Ends, [u, v]: Uv, mode: Mode = "polar"): MapRow[] {
  return frond.interpolate({ maps: from }, { maps: to }, { u, v, mode }).maps;
}

export function framesAlong(
  ends: Ends,
  points: readonly Uv[],
  count: number,
  mode: Mode = "polar",
): StripFrame[] {
  return Array.from({ length: count }, (_, i) => {
    const t = i / (count - 1);
    return { t, maps: mapsAt(ends, uvAt(points, t), mode) };
  });
}

/** A box that holds them all, except those that grow beyond measure: they would make all others specks. */
export function boxAround(all: readonly MapRow[][]): Box {
  const boxes = all.map(boxOf).filter((box) => box !== null);
  const sizes = boxes.map(diagonal).sort((p, q) => p - q);
  const most = 3 * (sizes[Math.floor(sizes.length / 2)] ?? 1);
  const counted = boxes.filter((box) => diagonal(box) <= most);
  if (counted.length === 0) return { x0: 0, y0: 0, x1: 1, y1: 1 };
  return {
    x0: Math.min(...counted.map((box) => box.x0)),
    y0: Math.min(...counted.map((box) => box.y0)),
    x1: Math.max(...counted.map((box) => box.x1)),
    y1: Math.max(...counted.map((box) => box.y1)),
  };
}

/** The determinant of the first map over the whole morph, as pairs of t and its value. */
export function determinants(ends: Ends, mode: Mode, steps = 40): [number, number][] {
  return Array.from({ length: steps + 1 }, (_, i) => {
    const t = i / steps;
    const [first] = mapsAt(ends, [t, t], mode);
    return [t, first ? determinant(first) : 0];
  });
}
