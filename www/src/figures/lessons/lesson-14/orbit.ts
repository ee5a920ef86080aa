/** Where points go when a map that leaves the middle in place is applied again and again. */
import type { MapRow } from "#wasm/api";
import { apply, type Point } from "../../kit/maps/pieces";

/** Turns by so many degrees and multiplies all distances from the middle by `scale`. */
export function turning(scale: number, degrees: number): MapRow {
  const [x, y] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  return [scale * x, -scale * y, scale * y, scale * x, 0, 0];
}

/** Multiplies across and up by `scale`, and moves to the side by `push` for each unit up. */
export function pushing(scale: number, push: number): MapRow {
  return [scale, push, 0, scale, 0, 0];
}

/** A point and where it is after 1, 2, .. maps, the first one applied first. */
export function orbit(maps: readonly MapRow[], start: Point): Point[] {
  const points = [start];
  let here = start;
  for (const map of maps) {
    here = apply(map, here);
    points.push(here);
  }
  return points;
}

/** So many times the same map. */
export function repeated(map: MapRow, times: number): MapRow[] {
  return Array.from({ length: times }, () => map);
}

export function far([x, y]: Point): number {
  return Math.hypot(x, y);
}

/** Another ruler: what is up counts more than what is across. */
export function weighed([x, y]: Point, weight: number): number {
  return Math.abs(x) + weight * Math.abs(y);
}

/** Two digits that count, as a plain number: 240, 2.8, 0.042. */
export function timesWords(times: number): string {
  const digits = Math.max(0, 1 - Math.floor(Math.log10(times)));
  return Number(times.toPrecision(2)).toFixed(Math.min(20, digits));
}

/** A length of at most a metre in the unit in which one would say it. */
export function metresWords(metres: number): string {
  if (metres >= 1) return "1 m";
  if (metres >= 0.01) return `${timesWords(100 * metres)} cm`;
  return metres >= 1e-6 ? `${timesWords(1000 * metres)} mm` : "less than 0.001 mm";
}
