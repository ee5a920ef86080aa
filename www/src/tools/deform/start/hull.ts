/**
 * The convex hull of points x0, y0, x1, y1, .., counter-clockwise, its sides without points between (Andrew's chain).
 */
export function hullOf(points: ArrayLike<number>): [x: number, y: number][] {
  const sorted = Array.from({ length: Math.floor(points.length / 2) }, (_, i): [number, number] => [
    points[2 * i] ?? 0,
    points[2 * i + 1] ?? 0,
  ]).sort(([x0, y0], [x1, y1]) => x0 - x1 || y0 - y1);
  const lower = chain(sorted);
  const upper = chain(sorted.reverse());
  return lower.length < 2 ? lower : [...lower.slice(0, -1), ...upper.slice(0, -1)];
}

/** The points of one side: each turns left. */
function chain(points: readonly [number, number][]): [number, number][] {
  const kept: [number, number][] = [];
  for (const p of points) {
    while (kept.length > 1 && !turnsLeft(kept.at(-2) ?? p, kept.at(-1) ?? p, p)) kept.pop();
    kept.push(p);
  }
  return kept;
}

function turnsLeft(p: readonly number[], q: readonly number[], r: readonly number[]): boolean {
  const [px = 0, py = 0] = p;
  const [qx = 0, qy = 0] = q;
  const [rx = 0, ry = 0] = r;
  return (qx - px) * (ry - py) - (qy - py) * (rx - px) > 0;
}
