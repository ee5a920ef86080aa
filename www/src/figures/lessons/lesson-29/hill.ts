/** Curves over three points: a tent whose halves carry flattened copies of the whole. */
import { dimension, type Rough } from "../lesson-18/rough";

/** The tent with copies that are `s` times as tall on each half: f(x) = s f(2x) + 2x, and the same from the right. */
export const tent = (s: number): Rough => ({ heights: [0, 1, 0], factors: [s, s] });

/** Where it is a parabola: what each step adds is a quarter as tall (Archimedes). */
export const SMOOTH = 0.25;
/** From here on it is as high over a quarter as in the middle, and has no finite slope anywhere (Takagi 1903). */
export const LEVEL = 0.5;
/** The largest factor that is offered: at 1 nothing would shrink any more. */
export const MOST = 0.9;

/** Its height over a quarter: half of that in the middle, and what the copy adds there. */
export const quarter = (s: number) => 0.5 + s;

/** Its height at x, so many steps deep. */
export function height(s: number, x: number, steps = 60): number {
  let [sum, scale, at] = [0, 1, x];
  for (let k = 0; k < steps; k++) {
    sum += scale * Math.min(2 * at, 2 - 2 * at);
    scale *= s;
    at = (2 * at) % 1;
  }
  return sum;
}

/** Whether its dimension is half-way between a line and an area, as nearly as hundredths can say it. */
export const isHalfWay = (s: number) => Math.abs(dimension(tent(s)) - 1.5) < 0.01;
