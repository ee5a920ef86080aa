/** The edges of a curve as parts of its polyline. Points are x0, y0, x1, y1, .. */

/** Where each edge begins in the polyline, and its number of points at the end; null where a knot is none of them. */
export function edgeStarts(
  points: ArrayLike<number>,
  knots: readonly (readonly [x: number, y: number])[],
): number[] | null {
  const count = points.length / 2;
  const starts: number[] = [];
  let at = 0;
  for (const [x, y] of knots) {
    while (at < count && (points[2 * at] !== x || points[2 * at + 1] !== y)) at++;
    if (at === count) return null;
    starts.push(at);
    at++;
  }
  return [...starts, count];
}

/** The points of so many edges from one on, to the knot where they end. */
export function edgePath(
  points: ArrayLike<number>,
  starts: readonly number[],
  from: number,
  span = 1,
): Float64Array {
  const edges = starts.length - 1;
  const path: number[] = [];
  for (let k = 0; k < span; k++) {
    const edge = (from + k) % edges;
    for (let i = starts[edge] ?? 0; i < (starts[edge + 1] ?? 0); i++) {
      path.push(points[2 * i] ?? 0, points[2 * i + 1] ?? 0);
    }
  }
  const end = starts[(from + span) % edges] ?? 0;
  path.push(points[2 * end] ?? 0, points[2 * end + 1] ?? 0);
  return Float64Array.from(path);
}

/** How far a point is from an open polyline. */
export function distanceTo(path: ArrayLike<number>, x: number, y: number): number {
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; i + 3 < path.length; i += 2) {
    const [ax, ay, bx, by] = [path[i] ?? 0, path[i + 1] ?? 0, path[i + 2] ?? 0, path[i + 3] ?? 0];
    const [dx, dy] = [bx - ax, by - ay];
    const size = dx * dx + dy * dy;
    const share = size > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / size)) : 0;
    least = Math.min(least, Math.hypot(x - ax - share * dx, y - ay - share * dy));
  }
  return least;
}
