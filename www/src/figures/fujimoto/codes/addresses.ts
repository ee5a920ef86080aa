/** Addresses of points on gaskets: which words of maps lead to them, all of them where there are several. */
import type { MapRow } from "#wasm/api";
import { apply, type Point } from "../../kit/maps/pieces";

export type Triangle = readonly [Point, Point, Point];

/** The gaskets of Figure 2: three maps of scale `r` that keep the corners of the right triangle (0,0), (1,0), (0,1). */
export function rightGasket(r: number): MapRow[] {
  return CORNERS.map(([x, y]): MapRow => [r, 0, 0, r, (1 - r) * x, (1 - r) * y]);
}

export const CORNERS: Triangle = [
  [0, 0],
  [1, 0],
  [0, 1],
];

/** The map of a word: its first letter is the largest piece, so it is applied last. */
function wordMap(maps: readonly MapRow[], word: readonly number[]): MapRow {
  return word.reduce<MapRow>((map, letter) => after(map, maps[letter] ?? IDENTITY), IDENTITY);
}

const IDENTITY: MapRow = [1, 0, 0, 1, 0, 0];

/** First `inner`, then `outer`. */
function after([a, b, c, d, e, f]: MapRow, [p, q, r, s, x, y]: MapRow): MapRow {
  return [a * p + b * r, a * q + b * s, c * p + d * r, c * q + d * s, a * x + b * y + e, c * x + d * y + f];
}

/** The piece of a word, as the triangle that holds it. */
export function pieceOf(maps: readonly MapRow[], word: readonly number[]): Triangle {
  const map = wordMap(maps, word);
  return CORNERS.map((corner) => apply(map, corner)) as unknown as Triangle;
}

/** Rounding: far below what is seen, far above what a few dozen products lose. */
const TOUCH = 1e-9;

/** All words of so many letters whose pieces hold a point, at most `most`; corners and edges belong to their pieces. */
export function addresses(r: number, point: Point, letters: number, most = 4096): number[][] {
  const found: number[][] = [];
  const look = ([x, y]: Point, word: number[], scale: number) => {
    const slack = TOUCH / scale;
    if (found.length >= most || x < -slack || y < -slack || x + y > 1 + slack) return;
    if (word.length === letters) {
      found.push(word);
      return;
    }
    for (const [letter, [cx, cy]] of CORNERS.entries()) {
      look([(x - (1 - r) * cx) / r, (y - (1 - r) * cy) / r], [...word, letter], scale * r);
    }
  };
  look(point, [], 1);
  return found;
}

/** The nearest point of the gasket, as far as so many letters tell: the edges of all its triangles belong to it. */
export function onGasket(r: number, point: Point, letters = 12): Point {
  let best: { at: Point; far: number } | null = null;
  const visit = (corner: Point, side: number, depth: number) => {
    const at = nearest(corner, side, point);
    const far = Math.hypot(at[0] - point[0], at[1] - point[1]);
    if (best && far >= best.far) return;
    if (depth === letters) {
      best = { at, far };
      return;
    }
    const parts = CORNERS.map(([x, y]): Point => {
      return [corner[0] + (1 - r) * side * x, corner[1] + (1 - r) * side * y];
    });
    const reach = (part: Point) => {
      const [x, y] = nearest(part, r * side, point);
      return Math.hypot(x - point[0], y - point[1]);
    };
    for (const part of parts.sort((p, q) => reach(p) - reach(q))) visit(part, r * side, depth + 1);
  };
  visit([0, 0], 1, 0);
  return (best as { at: Point } | null)?.at ?? [0, 0];
}

/** The point of a right triangle with its right angle at `corner` that is nearest to another. */
function nearest([x0, y0]: Point, side: number, [px, py]: Point): Point {
  const [x, y] = [(px - x0) / side, (py - y0) / side];
  const within = (value: number) => Math.min(1, Math.max(0, value));
  if (x >= 0 && y >= 0 && x + y <= 1) return [px, py];
  // Beyond the long side, or beyond one of the two short ones.
  if (x + y > 1) {
    const t = within((x - y + 1) / 2);
    return [x0 + t * side, y0 + (1 - t) * side];
  }
  return [x0 + (x < 0 ? 0 : within(x)) * side, y0 + (y < 0 ? 0 : within(y)) * side];
}
