/** What the panel and the handles do to a bend, as functions from bend to bend. Pure. */
import { bernstein, foldedPart } from "#geometry/folds";
import type { Point3, Space, SpaceBend } from "#wasm/api";
import * as messages from "../messages";

export const LEAST_SIDE = 2;
export const MOST_SIDE = 6;
/** As far as a control point goes, in longest sides of the box. */
export const FARTHEST = 10;
export const MOST_ROUGHNESS = 1.5;
const REST: Point3 = [0, 0, 0];

/** A lattice at rest, and how small parts would answer. */
export function atRest(sizes: SpaceBend["sizes"], detail: number): SpaceBend {
  const moves = Array.from({ length: sizes[0] * sizes[1] * sizes[2] }, () => REST);
  return { sizes, moves, kb: 0, ke: detail, delta: 0.5, spin: "none" };
}

/** Of an object; null: not bent. */
export function withBend(space: Space, index: number, bend: SpaceBend | null): Space {
  const objects = space.objects.map((object, i) => {
    if (i !== index) return object;
    const { bend: _, ...plain } = object;
    return bend ? { ...plain, bend } : plain;
  });
  return { ...space, objects };
}

/** A control point moved by so much more, as far as any goes. */
export function withMoved(bend: SpaceBend, index: number, by: Point3): SpaceBend {
  const before = bend.moves[index];
  if (!before || !by.every(Number.isFinite)) return bend;
  // What sums leave behind the ninth digit nobody meant.
  const sum = (x: number, axis: number) => Number((x + (by[axis] ?? 0)).toFixed(9));
  const to = before.map((x, axis) => within(sum(x, axis), -FARTHEST, FARTHEST)) as Point3;
  return { ...bend, moves: bend.moves.map((old, i) => (i === index ? to : old)) };
}

export function withLocality(bend: SpaceBend, kb: number): SpaceBend {
  return { ...bend, kb: within(kb, 0, bend.ke) };
}

/** The locality is no larger than the detail. */
export function withDetail(bend: SpaceBend, ke: number): SpaceBend {
  return { ...bend, ke, kb: Math.min(bend.kb, ke) };
}

/** Another number of control points, each where the lattice before has that place. */
export function withSizes(bend: SpaceBend, sizes: SpaceBend["sizes"]): SpaceBend {
  const count = sizes[0] * sizes[1] * sizes[2];
  const moves = Array.from({ length: count }, (_, i) => movedAt(bend, placeOf(sizes, i)));
  return { ...bend, sizes, moves };
}

/** Where control point `i` lies in the box: 0 to 1 along each axis. */
export function placeOf([columns, rows, layers]: SpaceBend["sizes"], i: number): Point3 {
  const [x, y, z] = [i % columns, Math.floor(i / columns) % rows, Math.floor(i / (columns * rows))];
  return [x / (columns - 1), y / (rows - 1), z / (layers - 1)];
}

/** The displacement of a place of the box, in longest sides of it. */
export function movedAt({ sizes, moves }: SpaceBend, place: Point3): Point3 {
  const shares = sizes.map((size, axis) => bernstein(place[axis] ?? 0, size));
  const sum: Point3 = [0, 0, 0];
  for (const [i, by] of moves.entries()) {
    const [columns, rows] = sizes;
    const at = [i % columns, Math.floor(i / columns) % rows, Math.floor(i / (columns * rows))];
    const share = at.reduce((product, k, axis) => product * (shares[axis]?.[k] ?? 0), 1);
    for (const axis of [0, 1, 2] as const) sum[axis] += share * by[axis];
  }
  return sum;
}

/** The part of the box that is turned over by the plain displacement; `sides` are its sides, the longest of them 1. */
export const foldedOf = (bend: SpaceBend, sides: Point3): number =>
  foldedPart(3, ([x = 0, y = 0, z = 0]) => {
    const by = movedAt(bend, [x, y, z]);
    return [x * sides[0] + by[0], y * sides[1] + by[1], z * sides[2] + by[2]];
  });

/** Pairs of neighbouring control points: the lines of the lattice. */
export function linesOf(sizes: SpaceBend["sizes"]): [number, number][] {
  const [columns, rows, layers] = sizes;
  const found: [number, number][] = [];
  for (let i = 0; i < columns * rows * layers; i++) {
    if (i % columns < columns - 1) found.push([i, i + 1]);
    if (Math.floor(i / columns) % rows < rows - 1) found.push([i, i + columns]);
    if (i < columns * rows * (layers - 1)) found.push([i, i + columns * rows]);
  }
  return found;
}

export interface Example {
  id: string;
  label: string;
  about: string;
  /** How far a place of the box is moved, in longest sides. */
  move: (place: Point3) => Point3;
}

/** Ways to move all control points at once. */
export const EXAMPLES: readonly Example[] = [
  {
    id: "corner",
    label: messages.liftCorner,
    about: messages.oneCornerLatticePulled,
    move: ([x, y, z]) => (x === 1 && y === 1 && z === 1 ? [0.35, 0.25, 0.45] : [0, 0, 0]),
  },
  {
    id: "twist",
    label: messages.twist,
    about: messages.eachLayerRotatedUpper,
    move: ([x, y, z]) => {
      const [c, s] = [Math.cos(1.2 * z), Math.sin(1.2 * z)];
      const [dx, dy] = [x - 0.5, y - 0.5];
      return [c * dx - s * dy - dx, s * dx + c * dy - dy, 0];
    },
  },
  {
    id: "lean",
    label: messages.lean,
    about: messages.upperLayersMoveTo,
    move: ([, , z]) => [0.5 * z * z, 0, -0.08 * z],
  },
  {
    id: "out",
    label: messages.swell,
    about: messages.centreEachFacePushed,
    move: ([x, y, z]) => {
      const by = (t: number, a: number, b: number) => 1.6 * (t - 0.5) * a * (1 - a) * b * (1 - b) * 4;
      return [by(x, y, z), by(y, x, z), by(z, x, y)];
    },
  },
  {
    id: "inside-out",
    label: messages.insideOut,
    about: messages.eachControlPointMoves,
    move: ([x, y, z]) => [1 - 2 * x, 1 - 2 * y, 1 - 2 * z],
  },
];

/** All control points moved as an example has it; `sides` of the box, the longest of which is 1. */
export function asExample(bend: SpaceBend, { move }: Example, sides: Point3): SpaceBend {
  const moves = bend.moves.map((_, i) => {
    const by = move(placeOf(bend.sizes, i));
    return by.map((x, axis) => tidy(x * (sides[axis] ?? 1))) as Point3;
  });
  return { ...bend, moves };
}

/** As fine as anyone can see, and short in a link. */
export function tidy(x: number): number {
  return Number(x.toFixed(5)) + 0;
}

export function isAtRest({ moves }: SpaceBend): boolean {
  return moves.every((by) => by.every((x) => x === 0));
}

function within(x: number, low: number, high: number): number {
  return Math.min(high, Math.max(low, x));
}

/** Where in the lattice a control point is, in words. */
export function nameOf(sizes: SpaceBend["sizes"], i: number): string {
  const [columns, rows] = sizes;
  const at = [i % columns, Math.floor(i / columns) % rows, Math.floor(i / (columns * rows))];
  return messages.handle(at.map((k) => k + 1).join(", "));
}
