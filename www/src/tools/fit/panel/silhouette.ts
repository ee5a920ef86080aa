/** The most corners of a small picture of an outline. */
const MOST_CORNERS = 200;

/**
 * An outline (x, y, x, y, .. with y up) as the path of a small picture, in the middle of a square of `side` with y
 * down. Empty where it has no extent.
 */
export function pathOf(points: Float64Array, side: number): string {
  const count = points.length / 2;
  const xs = points.filter((_, i) => i % 2 === 0);
  const ys = points.filter((_, i) => i % 2 === 1);
  const range = (list: Float64Array) =>
    list.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)] as const, [
      Number.POSITIVE_INFINITY,
      Number.NEGATIVE_INFINITY,
    ] as readonly [number, number]);
  const [[left, right], [bottom, top]] = [range(xs), range(ys)];
  const scale = side / Math.max(right - left, top - bottom);
  if (!(scale > 0 && Number.isFinite(scale))) return "";
  const [x0, y0] = [side / 2 - (scale * (left + right)) / 2, side / 2 + (scale * (bottom + top)) / 2];
  const stride = Math.ceil(count / MOST_CORNERS);
  const corners: string[] = [];
  for (let i = 0; i < count; i += stride)
    corners.push(`${(x0 + scale * (xs[i] ?? 0)).toFixed(1)} ${(y0 - scale * (ys[i] ?? 0)).toFixed(1)}`);
  return `M${corners.join("L")}Z`;
}
