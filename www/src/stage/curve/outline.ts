/** A closed curve on a canvas: from vertices in the plane to what is filled and what is stroked, in device pixels. */
import type { View } from "#geometry/coordinates";

/** What takes a path: a `Path2D`, or the tests' own. */
export type Sink = Pick<Path2D, "moveTo" | "lineTo" | "closePath">;

/** A canvas of so many device pixels, and what it shows; `view.scale` is in device pixels a unit. */
export interface Frame {
  view: View;
  width: number;
  height: number;
}

/** Beyond so many pixels outside, vertices are cut off: a canvas counts in single precision. */
const BEYOND = 256;

/** A closed polyline where it lies on a canvas. */
export interface Placed {
  /** x0, y0, x1, y1, .. in device pixels, y down; the first is not repeated. */
  readonly points: Float64Array;
  /** What of the plane is drawn at all: left, top, right, bottom. */
  readonly box: readonly [number, number, number, number];
  /** Whether all of it lies there. */
  readonly inside: boolean;
  /** The box around it. */
  readonly extent: readonly [number, number, number, number];
}

/** Vertices of the plane, y up, on a canvas. */
export function place(vertices: Float64Array, { view, width, height }: Frame): Placed {
  const points = new Float64Array(vertices.length);
  const [x0, y0, x1, y1] = [-BEYOND, -BEYOND, width + BEYOND, height + BEYOND];
  let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i + 1 < vertices.length; i += 2) {
    // The difference first: far in, the plane's coordinates have few digits to spare.
    const x = width / 2 + ((vertices[i] ?? 0) - view.x) * view.scale;
    const y = height / 2 - ((vertices[i + 1] ?? 0) - view.y) * view.scale;
    points[i] = x;
    points[i + 1] = y;
    left = Math.min(left, x);
    top = Math.min(top, y);
    right = Math.max(right, x);
    bottom = Math.max(bottom, y);
  }
  const inside = left >= x0 && right <= x1 && top >= y0 && bottom <= y1;
  return { points, box: [x0, y0, x1, y1], inside, extent: [left, top, right, bottom] };
}

/** What is inside the curve. */
export function fillPath(sink: Sink, { points, box, inside }: Placed): void {
  const ring = inside ? points : cut(points, box);
  for (let i = 0; i + 1 < ring.length; i += 2) {
    if (i === 0) sink.moveTo(ring[0] ?? 0, ring[1] ?? 0);
    else sink.lineTo(ring[i] ?? 0, ring[i + 1] ?? 0);
  }
  if (ring.length > 0) sink.closePath();
}

/** The part of a polygon that lies in a box: cut by one side after another (Sutherland and Hodgman). */
function cut(points: ArrayLike<number>, box: Placed["box"]): number[] {
  let ring = Array.from(points);
  box.forEach((bound, side) => {
    const axis = side % 2;
    const sign = side < 2 ? 1 : -1;
    const out: number[] = [];
    for (let i = 0; i + 1 < ring.length; i += 2) {
      const j = (i + ring.length - 2) % ring.length;
      const before = sign * ((ring[j + axis] ?? 0) - bound);
      const here = sign * ((ring[i + axis] ?? 0) - bound);
      if (before >= 0 !== here >= 0) {
        const t = before / (before - here);
        for (const k of [0, 1]) {
          const [p, q] = [ring[j + k] ?? 0, ring[i + k] ?? 0];
          out.push(k === axis ? bound : p + t * (q - p));
        }
      }
      if (here >= 0) out.push(ring[i] ?? 0, ring[i + 1] ?? 0);
    }
    ring = out;
  });
  return ring;
}

/**
 * The outline, each segment in the path of its kind: `kindOf(i)` of that from vertex i to the next. What lies outside
 * is left out.
 */
export function outlinePaths<S extends Sink>(
  placed: Placed,
  make: () => S,
  kindOf: (segment: number) => number = () => 0,
): Map<number, S> {
  const { points, box, inside } = placed;
  const paths = new Map<number, S>();
  const count = points.length / 2;
  let [lastKind, lastX, lastY] = [-1, Number.NaN, Number.NaN];
  for (let i = 0; i < count; i++) {
    const j = i + 1 === count ? 0 : i + 1;
    const ends = [points[2 * i], points[2 * i + 1], points[2 * j], points[2 * j + 1]] as Segment;
    const seen = inside ? ends : clipped(ends, box);
    if (!seen) continue;
    const kind = kindOf(i);
    let path = paths.get(kind);
    if (!path) {
      path = make();
      paths.set(kind, path);
    }
    const [x0, y0, x1, y1] = seen;
    if (kind !== lastKind || x0 !== lastX || y0 !== lastY) path.moveTo(x0, y0);
    // The last vertex joins the first without a seam where all of it is one line.
    if (j === 0 && inside && paths.size === 1) path.closePath();
    else path.lineTo(x1, y1);
    [lastKind, lastX, lastY] = [kind, x1, y1];
  }
  return paths;
}

type Segment = [x0: number, y0: number, x1: number, y1: number];

/** The part of a segment that lies in a box (Liang and Barsky). */
function clipped([x0, y0, x1, y1]: Segment, box: Placed["box"]): Segment | null {
  const [dx, dy] = [x1 - x0, y1 - y0];
  let [from, to] = [0, 1];
  const sides: [number, number][] = [
    [-dx, x0 - box[0]],
    [-dy, y0 - box[1]],
    [dx, box[2] - x0],
    [dy, box[3] - y0],
  ];
  for (const [out, room] of sides) {
    if (out === 0 && room < 0) return null;
    if (out < 0) from = Math.max(from, room / out);
    else if (out > 0) to = Math.min(to, room / out);
  }
  if (!(from <= to)) return null;
  return [
    from > 0 ? x0 + from * dx : x0,
    from > 0 ? y0 + from * dy : y0,
    to < 1 ? x0 + to * dx : x1,
    to < 1 ? y0 + to * dy : y1,
  ];
}
