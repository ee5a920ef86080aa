/** Two curves in a square, each from one place of its border to another. */
import type { Point } from "../../kit/maps/pieces";
import { number, parts } from "../../kit/state/fields";

/** Places on the border: 0 to 4, counter-clockwise from the lower left corner, a side for each unit. */
export function onBorder(place: number): Point {
  const at = ((place % 4) + 4) % 4;
  const part = at % 1;
  if (at < 1) return [part, 0];
  if (at < 2) return [1, part];
  if (at < 3) return [1 - part, 1];
  return [0, 1 - part];
}

/** The place of the border that is nearest, as seen from the middle. */
export function placeOf([x, y]: Point): number {
  const [dx, dy] = [x - 0.5, y - 0.5];
  const most = Math.max(Math.abs(dx), Math.abs(dy));
  if (most === 0) return 0;
  const [u, v] = [0.5 + (0.5 * dx) / most, 0.5 + (0.5 * dy) / most];
  if (v === 0) return u;
  if (u === 1) return 1 + v;
  if (v === 1) return 3 - u;
  return 4 - v;
}

export interface Curve {
  from: number;
  to: number;
  /** How far it swings to both sides on its way. */
  swing: number;
}

/** As it stands in the address of the lesson. */
export const CURVE = parts<Curve>({
  from: number(0, 4, 2),
  to: number(0, 4, 2),
  swing: number(-0.6, 0.6, 2),
});

const STEPS = 60;

/** Points of a curve, all in the square: by way of the middle, with a wave on it. */
export function pointsOf({ from, to, swing }: Curve): Point[] {
  const [p, q] = [onBorder(from), onBorder(to)];
  const within = (x: number) => Math.min(1, Math.max(0, x));
  return Array.from({ length: STEPS + 1 }, (_, i): Point => {
    const t = i / STEPS;
    const [a, b, c] = [(1 - t) ** 2, 2 * t * (1 - t), t ** 2];
    const [x, y] = [a * p[0] + b * 0.5 + c * q[0], a * p[1] + b * 0.5 + c * q[1]];
    const wave = swing * Math.sin(3 * Math.PI * t);
    return [within(x - wave * (q[1] - p[1])), within(y + wave * (q[0] - p[0]))];
  });
}

/** Whether going once round the square one meets an end of the one, of the other, of the one and of the other. */
export function takeTurns(one: Curve, other: Curve): boolean {
  const round = (place: number) => (((place - one.from) % 4) + 4) % 4;
  const end = round(one.to);
  const inside = [other.from, other.to].filter((place) => round(place) > 0 && round(place) < end).length;
  const outside = [other.from, other.to].filter((place) => round(place) > end).length;
  return inside === 1 && outside === 1;
}

/** A point that both curves have, if there is one. */
export function meeting(one: Curve, other: Curve): Point | null {
  const [first, second] = [pointsOf(one), pointsOf(other)];
  for (const [i, p] of first.slice(1).entries())
    for (const [j, r] of second.slice(1).entries()) {
      const found = common(first[i] ?? p, p, second[j] ?? r, r);
      if (found) return found;
    }
  return null;
}

/** A point of two segments. */
function common(p: Point, q: Point, r: Point, s: Point): Point | null {
  const [ux, uy] = [q[0] - p[0], q[1] - p[1]];
  const [vx, vy] = [s[0] - r[0], s[1] - r[1]];
  const [wx, wy] = [r[0] - p[0], r[1] - p[1]];
  const det = ux * vy - uy * vx;
  if (Math.abs(det) < 1e-14) return null;
  const [t, k] = [(wx * vy - wy * vx) / det, (wx * uy - wy * ux) / det];
  const slack = 1e-9;
  if (t < -slack || t > 1 + slack || k < -slack || k > 1 + slack) return null;
  return [p[0] + t * ux, p[1] + t * uy];
}

/** Of the second exercise: both ends on one side, the right one. */
export const onRight = ({ from, to }: Curve) => [from, to].every((place) => place > 1 && place < 2);

/** Two pieces that seem to lie over each other, and are apart: s z - 1 and s z + 1. */
export const APART_S: [number, number] = [0.0227, 0.703];
