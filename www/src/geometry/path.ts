import type { PathPoint, Scene } from "#wasm/api";

/** A parameter of the morph; without a third number it lies in the plane w = 0. */
export type Uv = PathPoint;

/** The whole path, with both ends. */
export function pointsOf(path: Scene["path"]): Uv[] {
  const way: Uv[] = path.kind === "straight" ? [] : path.points;
  return [[0, 0], ...way, [1, 1]];
}

/**
 * The point at the fraction `t` of the path's length. `t` outside [0, 1] is clamped, and a path without length stays at
 * its first point.
 */
export function uvAt(points: readonly Uv[], t: number): Uv {
  const first = points[0] ?? [0, 0];
  const last = points.at(-1) ?? first;
  if (!(t > 0)) return [...first];
  if (t >= 1) return [...last];
  const lengths = points.slice(1).map((p, i) => distance(points[i] ?? p, p));
  let left = t * lengths.reduce((sum, l) => sum + l, 0);
  for (const [i, length] of lengths.entries()) {
    const from = points[i] ?? first;
    const to = points[i + 1] ?? last;
    if (left <= length && length > 0) {
      const s = left / length;
      return between(from, to, s);
    }
    left -= length;
  }
  return [...last];
}

/** The point at the fraction `s` of a segment. Segments of the plane w = 0 stay in it. */
function between(from: Readonly<Uv>, to: Readonly<Uv>, s: number): Uv {
  const mix = (a: number, b: number) => a + s * (b - a);
  const [u, v, w] = [mix(from[0], to[0]), mix(from[1], to[1]), mix(from[2] ?? 0, to[2] ?? 0)];
  return w === 0 ? [u, v] : [u, v, w];
}

/** The fraction of the length at which each point of the path lies: 0 first, 1 last. */
export function timesOf(points: readonly Uv[]): number[] {
  let sum = 0;
  const along = points.map((p, i) => {
    sum += i === 0 ? 0 : distance(points[i - 1] ?? p, p);
    return sum;
  });
  return sum > 0 ? along.map((s) => s / sum) : along.map(() => 0);
}

/** At most so many points of a path, both ends included, that depart from it as little as can be. */
export function thinned(points: readonly Uv[], most: number): Uv[] {
  let kept = [...points];
  for (let tolerance = 1e-3; kept.length > Math.max(2, most); tolerance *= 1.5)
    kept = simplified(points, tolerance);
  return kept;
}

/** Douglas and Peucker: leaves out what lies within `tolerance` of the chord. */
function simplified(points: readonly Uv[], tolerance: number): Uv[] {
  const first = points[0];
  const last = points.at(-1);
  if (!first || !last || points.length < 3) return [...points];
  let far = 0;
  let index = 0;
  for (const [i, p] of points.entries()) {
    const d = offset(p, first, last);
    if (d > far) {
      far = d;
      index = i;
    }
  }
  if (far <= tolerance) return [first, last];
  return [
    ...simplified(points.slice(0, index + 1), tolerance).slice(0, -1),
    ...simplified(points.slice(index), tolerance),
  ];
}

/** How far a point is from a segment. */
function offset(p: Uv, a: Uv, b: Uv): number {
  const d = difference(b, a);
  const q = difference(p, a);
  const dot = (x: Vector, y: Vector) => x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
  const square = dot(d, d);
  const t = Math.min(1, Math.max(0, square > 0 ? dot(q, d) / square : 0));
  return Math.hypot(q[0] - t * d[0], q[1] - t * d[1], q[2] - t * d[2]);
}

type Vector = [number, number, number];

function difference(p: Readonly<Uv>, q: Readonly<Uv>): Vector {
  return [p[0] - q[0], p[1] - q[1], (p[2] ?? 0) - (q[2] ?? 0)];
}

function distance(p: Readonly<Uv>, q: Readonly<Uv>): number {
  return Math.hypot(...difference(p, q));
}
