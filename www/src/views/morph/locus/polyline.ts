/** The path as a line of points in the (u, v) plane: finding, cutting, adding, moving. */
import type { Bounds } from "../../../engine/api";
import { STATE } from "../../../engine/breaks";
import type { LocusResult } from "../../../engine/results";
import { timesOf, type Uv, uvAt } from "../../../state/path";

export interface Nearest {
  /** The point of the path that is nearest. */
  at: Uv;
  /** Segment `segment` runs from point `segment` to the next. */
  segment: number;
  /** The fraction of the length of the path. */
  t: number;
  distance: number;
}

/** The nearest point of the path. A path of one point, or of no length, is that point. */
export function nearestOn(points: readonly Uv[], [u, v]: Uv): Nearest {
  const times = timesOf(points);
  const first = points[0] ?? [0, 0];
  let best: Nearest = { at: [...first], segment: 0, t: 0, distance: Math.hypot(u - first[0], v - first[1]) };
  points.slice(1).forEach((to, segment) => {
    const from = points[segment] ?? first;
    const du = to[0] - from[0];
    const dv = to[1] - from[1];
    const length2 = du * du + dv * dv;
    const s = length2 > 0 ? Math.min(1, Math.max(0, ((u - from[0]) * du + (v - from[1]) * dv) / length2)) : 0;
    const at: Uv = [from[0] + s * du, from[1] + s * dv];
    const distance = Math.hypot(u - at[0], v - at[1]);
    if (distance < best.distance) {
      const t0 = times[segment] ?? 0;
      best = { at, segment, t: t0 + s * ((times[segment + 1] ?? 1) - t0), distance };
    }
  });
  return best;
}

/** The number of the handle within `radius` of a point, the nearest one; of equals the first. -1 for none. */
export function hitHandle(handles: readonly Uv[], [u, v]: Uv, radius: number): number {
  let best = -1;
  let least = radius;
  handles.forEach(([hu, hv], index) => {
    const distance = Math.hypot(u - hu, v - hv);
    if (distance < least || (distance === least && best < 0)) {
      least = distance;
      best = index;
    }
  });
  return best;
}

/** The stretch of the path between two moments, with both ends and the points between them. */
export function slice(points: readonly Uv[], t0: number, t1: number): Uv[] {
  const times = timesOf(points);
  const between = points.filter((_, i) => (times[i] ?? 0) > t0 && (times[i] ?? 0) < t1);
  return [uvAt(points, t0), ...between.map(([u, v]): Uv => [u, v]), uvAt(points, t1)];
}

export function clamp([u, v]: Uv, { u0, v0, u1, v1 }: Bounds): Uv {
  return [Math.min(u1, Math.max(u0, u)), Math.min(v1, Math.max(v0, v))];
}

/** To the thousandth: finer than a pixel, and short in a link. */
export function rounded([u, v]: Uv): Uv {
  const round = (x: number) => Math.round(x * 1000) / 1000 || 0;
  return [round(u), round(v)];
}

/** `way` with one more point, so that it becomes number `index`. */
export function insert(way: readonly Uv[], index: number, point: Uv): Uv[] {
  return [...way.slice(0, index), point, ...way.slice(index)];
}

export function move(way: readonly Uv[], index: number, point: Uv): Uv[] {
  return way.map((old, i) => (i === index ? point : old));
}

export function remove(way: readonly Uv[], index: number): Uv[] {
  return way.filter((_, i) => i !== index);
}

/**
 * The widest gap met along the path, relative to the size of the shape, read off the nearest samples; null while no
 * sample along it is decided. Where there is no shape at all the gap has no size, and is passed over.
 */
export function widestAlong(field: LocusResult, points: readonly Uv[], samples = 257): number | null {
  const { width, height, bounds, state, gap } = field;
  let widest: number | null = null;
  for (let i = 0; i < samples; i++) {
    const [u, v] = uvAt(points, i / (samples - 1));
    const x = Math.round(((u - bounds.u0) / (bounds.u1 - bounds.u0)) * (width - 1));
    const y = Math.round(((v - bounds.v0) / (bounds.v1 - bounds.v0)) * (height - 1));
    if (x < 0 || y < 0 || x >= width || y >= height) continue;
    const here = state[y * width + x] ?? STATE.pending;
    const size = gap[y * width + x] ?? Number.NaN;
    if (here === STATE.pending || Number.isNaN(size)) continue;
    widest = Math.max(widest ?? 0, here === STATE.disconnected ? size : 0);
  }
  return widest;
}
