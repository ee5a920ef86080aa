/** A graph through points, made of copies of itself, and the points that the paper takes. */
import type { Graph } from "#wasm/api";
import { rough } from "#wasm/curve";

export type Points = readonly [t: number, x: number][];

export const FIGURE_1: { points: Points; c: readonly number[] } = {
  points: [
    [0, 0],
    [0.5, 1],
    [1, 0],
  ],
  c: [0.6, 0.4],
};

export function interpolated(
  points: Points,
  c: readonly number[],
  reflected: readonly boolean[] = [],
): Graph {
  return rough.interpolation(
    points.map(([t, x]): [number, number] => [t, x]),
    { c: [...c], reflected: c.map((_, i) => reflected[i] ?? false) },
  );
}
