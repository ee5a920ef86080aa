import type { Scene } from "../engine/api";

export type Uv = [u: number, v: number];

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
      return [from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1])];
    }
    left -= length;
  }
  return [...last];
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
  const [x, y] = [b[0] - a[0], b[1] - a[1]];
  const square = x * x + y * y;
  const s = square > 0 ? ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / square : 0;
  const t = Math.min(1, Math.max(0, s));
  return distance(p, [a[0] + t * x, a[1] + t * y]);
}

function distance(p: readonly [number, number], q: readonly [number, number]): number {
  return Math.hypot(q[0] - p[0], q[1] - p[1]);
}
