/** How far the pieces of a shape are from each other, pair by pair, and the tree that joins them most cheaply. */
import type { MapRow } from "#wasm/api";

export type Point = [x: number, y: number];

export interface Apart {
  between: [number, number];
  /** No nearer than this, and no farther than `upper`. */
  lower: number;
  upper: number;
  /** Two points of the pieces that are `upper` apart. */
  closest: [Point, Point];
}

/** A piece of a piece: its map, a point of the shape in it, and how far it may reach from that point. */
interface Part {
  map: MapRow;
  at: Point;
  reach: number;
}

interface Pair {
  one: Part;
  other: Part;
  lower: number;
}

/** Pairs looked at for one distance, at most. */
const BUDGET = 20_000;

/**
 * The least distance between each two pieces, between bounds that differ by at most `width` where the budget suffices.
 * The maps must shrink every length. Descends on pairs of parts, the nearest first, and splits the larger.
 */
export function distances(maps: readonly MapRow[], width = 1e-4): Apart[] {
  const pieces = maps.map((map) => partOf(map, maps));
  return pieces.flatMap((one, i) =>
    pieces.slice(i + 1).map((other, k): Apart => {
      const found = leastDistance(one, other, maps, width);
      return { between: [i, i + 1 + k], ...found };
    }),
  );
}

/** The widest edge of the cheapest tree through all pieces, which is the gap, and the tree itself. */
export function spanningTree(count: number, all: readonly Apart[]): { edges: Apart[]; widest: Apart | null } {
  const group = Array.from({ length: count }, (_, i) => i);
  const edges: Apart[] = [];
  for (const edge of [...all].sort((p, q) => p.upper - q.upper)) {
    const [a, b] = [group[edge.between[0]], group[edge.between[1]]];
    if (a === undefined || b === undefined || a === b) continue;
    edges.push(edge);
    for (let i = 0; i < count; i++) if (group[i] === b) group[i] = a;
  }
  return { edges, widest: edges.at(-1) ?? null };
}

function leastDistance(p: Part, q: Part, maps: readonly MapRow[], width: number): Omit<Apart, "between"> {
  const first = pairOf(p, q);
  let open = [first];
  let upper = apart(p.at, q.at);
  let closest: [Point, Point] = [p.at, q.at];
  let lower = first.lower;
  for (let looked = 0; looked < BUDGET && upper - lower > width; ) {
    // Whole levels at a time: what cannot be nearer than what is found already is dropped.
    const next: Pair[] = [];
    for (const { one, other } of open) {
      const splitOne = one.reach >= other.reach;
      for (const part of split(splitOne ? one : other, maps)) {
        const pair = splitOne ? pairOf(part, other) : pairOf(one, part);
        looked++;
        const d = apart(pair.one.at, pair.other.at);
        if (d < upper) {
          upper = d;
          closest = [pair.one.at, pair.other.at];
        }
        next.push(pair);
      }
    }
    open = next.filter((pair) => pair.lower <= upper - width / 2);
    lower = open.reduce((least, pair) => Math.min(least, pair.lower), upper - width / 2);
    if (open.length === 0) break;
  }
  // Without a disc that holds the shape nothing is known of what is between.
  const known = Number.isFinite(lower) ? Math.max(0, Math.min(lower, upper)) : 0;
  return { lower: known, upper, closest };
}

function pairOf(one: Part, other: Part): Pair {
  return { one, other, lower: Math.max(0, apart(one.at, other.at) - one.reach - other.reach) };
}

function apart([x, y]: Point, [u, v]: Point): number {
  return Math.hypot(x - u, y - v);
}

function split(part: Part, maps: readonly MapRow[]): Part[] {
  return maps.map((map) => partOf(compose(part.map, map), maps));
}

/** The part of the shape under a map: its reach is that of the whole about its middle, shrunk. */
function partOf(map: MapRow, maps: readonly MapRow[]): Part {
  const whole = disc(maps);
  return { map, at: apply(map, whole.middle), reach: norm(map) * whole.radius };
}

let kept: { of: readonly MapRow[]; disc: { middle: Point; radius: number } } | null = null;

/** A disc that holds the shape, about a point of it: the fixed point of the first map. */
function disc(maps: readonly MapRow[]): { middle: Point; radius: number } {
  if (kept?.of === maps) return kept.disc;
  const middle = fixed(maps[0] ?? [0, 0, 0, 0, 0, 0]);
  // |w x - m| <= s |x - m| + |w m - m|: the radius that each map keeps within itself.
  const radius = Math.max(
    ...maps.map((map) => {
      const s = norm(map);
      return s < 1 ? apart(apply(map, middle), middle) / (1 - s) : Number.POSITIVE_INFINITY;
    }),
  );
  kept = { of: maps, disc: { middle, radius } };
  return kept.disc;
}

function fixed([a, b, c, d, e, f]: MapRow): Point {
  const det = (1 - a) * (1 - d) - b * c;
  return [((1 - d) * e + b * f) / det, (c * e + (1 - a) * f) / det];
}

export function apply([a, b, c, d, e, f]: MapRow, [x, y]: Point): Point {
  return [a * x + b * y + e, c * x + d * y + f];
}

/** First `q`, then `p`. */
export function compose(p: MapRow, q: MapRow): MapRow {
  const [e, f] = apply(p, [q[4], q[5]]);
  return [
    p[0] * q[0] + p[1] * q[2],
    p[0] * q[1] + p[1] * q[3],
    p[2] * q[0] + p[3] * q[2],
    p[2] * q[1] + p[3] * q[3],
    e,
    f,
  ];
}

/** The most by which a map lengthens anything: the larger singular value of its linear part. */
export function norm([a, b, c, d]: MapRow): number {
  const half = (a * a + b * b + c * c + d * d) / 2;
  const det = a * d - b * c;
  return Math.sqrt(half + Math.sqrt(Math.max(0, half * half - det * det)));
}
