/**
 * Mean value coordinates of the plane (Floater, “Mean value coordinates”, 2003), for any polygon, and without angles
 * (Hormann & Floater, “Mean value coordinates for arbitrary planar polygons”, 2006): a point is a mean of
 * the corners, and the same mean of other corners is where it is carried to.
 */

/** Nearer than this, in parts of the polygon's size, a point is on a corner or an edge. */
const NEAR = 1e-9;

/**
 * Carries a point that lies in a polygon, or beside it, to where it lies in others.
 *
 * A ring is x0, y0, x1, y1, ..; each of `to` has as many corners as `from`. Writes x and y in each of them into `out`.
 */
export function carry(
  from: Float64Array,
  to: readonly Float64Array[],
  size: number,
  x: number,
  y: number,
  out: Float64Array,
): void {
  const count = from.length / 2;
  const near = NEAR * size;
  out.fill(0);
  let sum = 0;
  let px = (from[2 * count - 2] ?? 0) - x;
  let py = (from[2 * count - 1] ?? 0) - y;
  let pr = Math.hypot(px, py);
  let before = count - 1;
  for (let i = 0; i < count; i++) {
    const qx = (from[2 * i] ?? 0) - x;
    const qy = (from[2 * i + 1] ?? 0) - y;
    const qr = Math.sqrt(qx * qx + qy * qy);
    if (qr <= near) {
      mean(to, i, i, 0, out);
      return;
    }
    // Twice the area of the triangle with the edge, and the dot product of the ways to its ends.
    const area = px * qy - py * qx;
    const dot = px * qx + py * qy;
    if (Math.abs(area) <= near * near) {
      if (dot < 0) {
        mean(to, before, i, pr / (pr + qr), out);
        return;
      }
    } else {
      // The tangent of half the angle between the ways to the ends: what the edge gives to both.
      const tangent = (pr * qr - dot) / area;
      const [p, q] = [tangent / pr, tangent / qr];
      sum += p + q;
      for (let k = 0; k < to.length; k++) {
        const ring = to[k] as Float64Array;
        out[2 * k] = (out[2 * k] ?? 0) + p * (ring[2 * before] ?? 0) + q * (ring[2 * i] ?? 0);
        out[2 * k + 1] = (out[2 * k + 1] ?? 0) + p * (ring[2 * before + 1] ?? 0) + q * (ring[2 * i + 1] ?? 0);
      }
    }
    [px, py, pr, before] = [qx, qy, qr, i];
  }
  for (let k = 0; k < out.length; k++) out[k] = (out[k] ?? 0) / sum;
}

/** On the edge between two corners. */
function mean(to: readonly Float64Array[], i: number, j: number, share: number, out: Float64Array): void {
  to.forEach((ring, k) => {
    for (const axis of [0, 1]) {
      out[2 * k + axis] = (ring[2 * i + axis] ?? 0) * (1 - share) + (ring[2 * j + axis] ?? 0) * share;
    }
  });
}
