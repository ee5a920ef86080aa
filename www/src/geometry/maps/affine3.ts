/**
 * Small sums with maps of space, where a figure or a field wants them at once. What must be exact is asked of the
 * module.
 */
import type { MapRow3, Point3 } from "#wasm/api";

export function apply3(map: MapRow3, [x, y, z]: Point3): Point3 {
  return [
    map[0] * x + map[1] * y + map[2] * z + map[9],
    map[3] * x + map[4] * y + map[5] * z + map[10],
    map[6] * x + map[7] * y + map[8] * z + map[11],
  ];
}

/** First `inner`, then `outer`. */
export function after3(outer: MapRow3, inner: MapRow3): MapRow3 {
  const column = (k: 0 | 1 | 2): Point3 => turned(outer, [inner[k], inner[k + 3] ?? 0, inner[k + 6] ?? 0]);
  const [a, b, c] = [column(0), column(1), column(2)];
  const [x, y, z] = apply3(outer, [inner[9], inner[10], inner[11]]);
  return [a[0], b[0], c[0], a[1], b[1], c[1], a[2], b[2], c[2], x, y, z];
}

/** A direction, by the matrix alone. */
export function turned(map: MapRow3, [x, y, z]: Point3): Point3 {
  return [
    map[0] * x + map[1] * y + map[2] * z,
    map[3] * x + map[4] * y + map[5] * z,
    map[6] * x + map[7] * y + map[8] * z,
  ];
}

export function determinant3([a, b, c, d, e, f, g, h, i]: MapRow3): number {
  return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
}

export function shift3([x, y, z]: Point3): MapRow3 {
  return [1, 0, 0, 0, 1, 0, 0, 0, 1, x, y, z];
}

export function scale3([x, y, z]: Point3): MapRow3 {
  return [x, 0, 0, 0, y, 0, 0, 0, z, 0, 0, 0];
}

/** About x, then about y, then about z, in radians, counter-clockwise where the axis points at who looks. */
export function turns3([x, y, z]: Point3): MapRow3 {
  const [cx, sx, cy, sy, cz, sz] = [
    Math.cos(x),
    Math.sin(x),
    Math.cos(y),
    Math.sin(y),
    Math.cos(z),
    Math.sin(z),
  ];
  return [
    cz * cy,
    cz * sy * sx - sz * cx,
    cz * sy * cx + sz * sx,
    sz * cy,
    sz * sy * sx + cz * cx,
    sz * sy * cx - cz * sx,
    -sy,
    cy * sx,
    cy * cx,
    0,
    0,
    0,
  ];
}

/** The same with `centre` in the place of the origin. */
export function about3(map: MapRow3, centre: Point3): MapRow3 {
  const [x, y, z] = turned(map, centre);
  const [a, b, c, d, e, f, g, h, i, mx, my, mz] = map;
  return [a, b, c, d, e, f, g, h, i, mx + centre[0] - x, my + centre[1] - y, mz + centre[2] - z];
}
