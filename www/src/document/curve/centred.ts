/** Where curves lie that come from outlines: about the origin, their longer side 2, as the shapes of the gallery do. */
import type { Curve } from "#wasm/api";

/** What is to be the origin, and how many times larger all becomes. */
export interface Centring {
  x: number;
  y: number;
  scale: number;
}

export function centringOf({ knots }: Curve): Centring {
  const xs = knots.map(([x]) => x);
  const ys = knots.map(([, y]) => y);
  const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  return { x: (x0 + x1) / 2, y: (y0 + y1) / 2, scale: 2 / Math.max(x1 - x0, y1 - y0, 1e-12) };
}

export function centred(curve: Curve): Curve {
  const { x, y, scale } = centringOf(curve);
  return { knots: curve.knots.map(([a, b]) => [(a - x) * scale, (b - y) * scale]), edges: curve.edges };
}

type Box = readonly [x0: number, y0: number, x1: number, y1: number];

/** A box that lies where the curve does. */
export function centredBox(
  [x0, y0, x1, y1]: Box,
  { x, y, scale }: Centring,
): [number, number, number, number] {
  return [(x0 - x) * scale, (y0 - y) * scale, (x1 - x) * scale, (y1 - y) * scale];
}
