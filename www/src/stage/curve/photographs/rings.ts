/** The same places along a curve at several moments of its morph. */

/** A closed polyline x0, y0, x1, y1, .. and for each vertex the edge of the curve that goes on from there. */
export interface Traced {
  points: Float64Array;
  edges: ArrayLike<number>;
}

/** A place of a morphed curve: an edge, and the share of its length that lies before. It is the same at any moment. */
export interface Place {
  edge: number;
  share: number;
}

/** How far it is along a polyline from its first vertex to each of the others, and all around. */
function lengthsOf({ points }: Traced): Float64Array {
  const count = points.length / 2;
  const lengths = new Float64Array(count + 1);
  for (let i = 0; i < count; i++) {
    const j = (i + 1) % count;
    const dx = (points[2 * j] ?? 0) - (points[2 * i] ?? 0);
    const dy = (points[2 * j + 1] ?? 0) - (points[2 * i + 1] ?? 0);
    lengths[i + 1] = (lengths[i] ?? 0) + Math.hypot(dx, dy);
  }
  return lengths;
}

/** The vertex at which each edge begins, and the number of vertices at the end. Edges without length may have none. */
function startsOf({ points, edges }: Traced, count: number): Uint32Array {
  const starts = new Uint32Array(count + 1).fill(points.length / 2);
  for (let i = points.length / 2 - 1; i >= 0; i--) starts[Math.min(count - 1, edges[i] ?? 0)] = i;
  for (let edge = count - 1; edge >= 0; edge--) {
    starts[edge] = Math.min(starts[edge] ?? 0, starts[edge + 1] ?? 0);
  }
  return starts;
}

/** Places that are evenly spread over two polylines of one morph, whose curve has so many edges. */
export function placesOf(all: readonly Traced[], edges: number, count: number): Place[] {
  const sums = new Float64Array(edges + 1);
  for (const traced of all) {
    const [lengths, starts] = [lengthsOf(traced), startsOf(traced, edges)];
    const whole = (lengths.at(-1) ?? 0) * all.length;
    if (!(whole > 0)) continue;
    for (let edge = 0; edge <= edges; edge++) {
      sums[edge] = (sums[edge] ?? 0) + (lengths[starts[edge] ?? 0] ?? 0) / whole;
    }
  }
  let edge = 0;
  return Array.from({ length: count }, (_, k) => {
    const at = ((k + 0.5) / count) * (sums[edges] ?? 1);
    while (edge + 1 < edges && (sums[edge + 1] ?? 0) <= at) edge++;
    const [low, high] = [sums[edge] ?? 0, sums[edge + 1] ?? 0];
    return { edge, share: high > low ? (at - low) / (high - low) : 0 };
  });
}

/** Where places are at a moment: x0, y0, x1, y1, .. */
export function ringAt(traced: Traced, edges: number, places: readonly Place[]): Float64Array {
  const [lengths, starts] = [lengthsOf(traced), startsOf(traced, edges)];
  const { points } = traced;
  const count = points.length / 2;
  const ring = new Float64Array(2 * places.length);
  let i = 0;
  places.forEach(({ edge, share }, k) => {
    const [low, high] = [lengths[starts[edge] ?? 0] ?? 0, lengths[starts[edge + 1] ?? 0] ?? 0];
    const at = low + share * (high - low);
    i = Math.max(i, starts[edge] ?? 0);
    while (i + 1 < count && (lengths[i + 1] ?? 0) < at) i++;
    const [a, b] = [lengths[i] ?? 0, lengths[i + 1] ?? 0];
    const part = b > a ? Math.min(1, (at - a) / (b - a)) : 0;
    const j = (i + 1) % count;
    for (const axis of [0, 1]) {
      ring[2 * k + axis] = (points[2 * i + axis] ?? 0) * (1 - part) + (points[2 * j + axis] ?? 0) * part;
    }
  });
  return ring;
}
