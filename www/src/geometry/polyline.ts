/** The path as a line of points in the (u, v) plane: finding, cutting, adding, moving. */
import type { Bounds, Locus } from "#wasm/api";
import { timesOf, type Uv, uvAt } from "./path";
import { STATE } from "./states";

interface Nearest {
  /** The point of the path that is nearest. */
  at: Uv;
  /** Segment `segment` runs from point `segment` to the next. */
  segment: number;
  /** The fraction of the length of the path. */
  t: number;
  distance: number;
}

/** A parameter, without its third number where that is 0. */
export const pointOf = (u: number, v: number, w: number): Uv => (w === 0 ? [u, v] : [u, v, w]);

/** The nearest point of the path, as it is seen from above: w is of no account. A path of no length is that point. */
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
    const w = (from[2] ?? 0) + s * ((to[2] ?? 0) - (from[2] ?? 0));
    const at = pointOf(from[0] + s * du, from[1] + s * dv, w);
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
  return [uvAt(points, t0), ...between.map(([u, v, w = 0]): Uv => pointOf(u, v, w)), uvAt(points, t1)];
}

export function clamp([u, v, w = 0]: Uv, { u0, v0, u1, v1 }: Bounds): Uv {
  const within = (x: number, low: number, high: number) => Math.min(high, Math.max(low, x));
  return pointOf(within(u, u0, u1), within(v, v0, v1), within(w, -1, 1));
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

/** The part of a segment that lies in a rectangle: Liang and Barsky. Null where there is none. */
export function clipped(from: Readonly<Uv>, to: Readonly<Uv>, { u0, v0, u1, v1 }: Bounds): [Uv, Uv] | null {
  let [s0, s1] = [0, 1];
  const [du, dv] = [to[0] - from[0], to[1] - from[1]];
  for (const [p, q] of [
    [-du, from[0] - u0],
    [du, u1 - from[0]],
    [-dv, from[1] - v0],
    [dv, v1 - from[1]],
  ] as const) {
    if (p === 0 && q < 0) return null;
    if (p < 0) s0 = Math.max(s0, q / p);
    if (p > 0) s1 = Math.min(s1, q / p);
  }
  if (s0 > s1) return null;
  const at = (s: number): Uv => [from[0] + s * du, from[1] + s * dv];
  return [s0 === 0 ? [from[0], from[1]] : at(s0), s1 === 1 ? [to[0], to[1]] : at(s1)];
}

/** A line as its pieces within a slice, `thick` to both sides of w, and those beyond it. */
export function sliced(
  points: readonly Uv[],
  slice: number,
  thick: number,
): { near: [Uv, Uv][]; far: [Uv, Uv][] } {
  const near: [Uv, Uv][] = [];
  const far: [Uv, Uv][] = [];
  points.slice(1).forEach((to, i) => {
    const from = points[i] ?? to;
    const [w0, w1] = [(from[2] ?? 0) - slice, (to[2] ?? 0) - slice];
    const cuts = w0 === w1 ? [] : [(-thick - w0) / (w1 - w0), (thick - w0) / (w1 - w0)];
    const at = (s: number): Uv => [from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1])];
    const ends = [0, ...cuts.filter((s) => s > 0 && s < 1).sort((p, q) => p - q), 1];
    ends.slice(1).forEach((s1, k) => {
      const s0 = ends[k] ?? 0;
      const middle = w0 + ((s0 + s1) / 2) * (w1 - w0);
      (Math.abs(middle) <= thick ? near : far).push([at(s0), at(s1)]);
    });
  });
  return { near, far };
}

/** A line as the pieces of it that lie in a rectangle, each of two points. */
export function piecesIn(points: readonly Uv[], within: Bounds): [Uv, Uv][] {
  return points.slice(1).flatMap((to, i) => {
    const piece = clipped(points[i] ?? to, to, within);
    return piece ? [piece] : [];
  });
}

/**
 * The widest gap met along the path, relative to the size of the shape, read off the nearest samples; null while no
 * sample along it is decided. Where there is no shape at all the gap has no size, and is passed over.
 */
export function widestAlong(
  field: Locus & { bounds: Bounds },
  points: readonly Uv[],
  samples = 257,
): number | null {
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
