/** How far the two ways to move a shape are apart: to move its points, and to move its parameters (eq 1). */

import * as messages from "../messages";
import { axesOf, type Row } from "./row";

export interface Apart {
  points: number;
  /** The largest distance between a point moved and the same point drawn by the moved parameters. */
  most: number;
  /** The diagonal of the box around the moved points, to compare it with. */
  size: number;
}

/** Both forget where they have started. */
const FORGET = 400;

/**
 * Plays one chaos game twice, with the same maps in the same order: once with the parameters as made, whose points are
 * then moved by `by`, and once with the moved parameters.
 */
export function apartBy<Map extends Row>(
  made: readonly Map[],
  now: readonly Map[],
  by: Map,
  points = 2000,
): Apart {
  const count = Math.min(made.length, now.length);
  const axes = axesOf(by);
  // Written over and over: this is asked for at every step of a hand.
  const plain = new Float64Array(axes);
  const drawn = new Float64Array(axes);
  const moved = new Float64Array(axes);
  const low = new Float64Array(axes).fill(Infinity);
  const high = new Float64Array(axes).fill(-Infinity);
  let seed = 1;
  let most = 0;
  for (let i = 0; i < FORGET + points && count > 0; i++) {
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    const map = Math.floor((seed / 2 ** 32) * count);
    take(made[map] as Map, plain, plain);
    take(now[map] as Map, drawn, drawn);
    if (i < FORGET) continue;
    take(by, plain, moved);
    let sum = 0;
    for (let k = 0; k < axes; k++) {
      const at = moved[k] ?? 0;
      sum += (at - (drawn[k] ?? 0)) ** 2;
      if (at < (low[k] ?? 0)) low[k] = at;
      if (at > (high[k] ?? 0)) high[k] = at;
    }
    const distance = Math.sqrt(sum);
    // What is no number at all is no small distance either.
    if (!(distance <= most)) most = distance;
  }
  return { points, most, size: Math.hypot(...high.map((x, k) => x - (low[k] ?? 0))) };
}

const before = new Float64Array(3);

function take(map: Row, from: Float64Array, to: Float64Array): void {
  const axes = from.length;
  before.set(from);
  for (let row = 0; row < axes; row++) {
    let sum = map[axes * axes + row] ?? 0;
    for (let k = 0; k < axes; k++) sum += (map[axes * row + k] ?? 0) * (before[k] ?? 0);
    to[row] = sum;
  }
}

/** The distance in words: as a part of the size, as nobody sees anything below a pixel. */
export function apartWords({ most, size, points }: Apart): string {
  const count = points.toLocaleString("en");
  const part = most / size;
  if (most === 0) return messages.allPointsSame(count);
  if (!Number.isFinite(part)) return messages.pointsWithoutSize;
  const power = Math.ceil(Math.log10(part));
  if (part < 1e-9) return messages.apartByRounding(count, superscript(power));
  return messages.apartBy(count, superscript(power));
}

function superscript(n: number): string {
  return String(n).replace(/[-0-9]/g, (c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹".at(c === "-" ? 0 : Number(c) + 1) ?? "");
}
