/** What the scan of Darwish & Abd-El-Wahab shows of the parameters under its Figures i to vi. */
import type { Point3 } from "#wasm/api";

/** The translations under Figure iv, which are printed whole. Each matrix is 0.5 I. */
export const FIGURE_IV: readonly Point3[] = [
  [15.07, 0.05, -0.02],
  [15.34, 0.03, 0.25],
  [15.38, 0.32, 0.16],
];

/** A number of a translation that can be read, and its place: the map and the axis, both from 0. */
export type Legible = readonly [map: number, axis: number, value: number];

/** The middle row of Figure i: a comma stands before each translation there. */
export const FIGURE_I: readonly Legible[] = [
  [0, 1, 0.06],
  [1, 1, 0],
  [2, 1, 0.3],
];

/** The middle row of Figure ii. Of another row 0.14 is left, and not of which map: it stands for the first here. */
export const FIGURE_II: readonly Legible[] = [
  [0, 1, -0.06],
  [1, 1, 0.03],
  [2, 1, 0.23],
  [0, 2, 0.14],
];

export const FIGURE_III: readonly Legible[] = [
  [0, 0, 14.99],
  [0, 1, -0.08],
  [1, 0, 15.33],
  [2, 1, -0.45],
];

/** To one decimal. Of the maps that 0.3 belongs to nothing else is left: two of them have it as second number here. */
export const FIGURE_V: readonly Legible[] = [
  [0, 0, 15],
  [1, 1, 0.3],
  [3, 1, 0.3],
];

/** The upper row, to one decimal; the fifth map is cut off. */
export const FIGURE_VI: readonly Legible[] = [
  [0, 0, 15.1],
  [1, 0, 15.3],
  [2, 0, 15.4],
  [3, 0, 15.5],
];
