/** Editing alike on both sides: which control point answers which, and how. */
import { signal } from "@preact/signals";
import type { Mesh } from "#geometry/mesh";

/** Mirrored left to right, up and down, or turned by half a turn. */
export type Symmetry = "off" | "sides" | "levels" | "point";

/** How the hand edits; no part of the document. */
export const symmetry = signal<Symmetry>("off");

type Sides = Pick<Mesh, "columns" | "rows">;

/** The control point that answers one. */
export function partner({ columns, rows }: Sides, index: number, by: Symmetry): number {
  const column = index % columns;
  const row = (index - column) / columns;
  const across = by === "sides" || by === "point" ? columns - 1 - column : column;
  const up = by === "levels" || by === "point" ? rows - 1 - row : row;
  return up * columns + across;
}

/** How its displacement answers: the factors of dx and dy. */
export function answer(by: Symmetry): readonly [number, number] {
  return [by === "sides" || by === "point" ? -1 : 1, by === "levels" || by === "point" ? -1 : 1];
}

/**
 * What each control point moves by when those chosen move by (dx, dy): they and, mirrored, their partners. Of two
 * chosen partners the one nearer to the one that is held leads; one on the axis stays on it.
 */
export function spread(
  mesh: Sides,
  chosen: Iterable<number>,
  held: number,
  [dx, dy]: readonly [number, number],
  by: Symmetry,
): Map<number, readonly [number, number]> {
  const out = new Map<number, readonly [number, number]>();
  const all = new Set(chosen);
  const [fx, fy] = answer(by);
  for (const index of all) {
    const other = partner(mesh, index, by);
    if (by === "off") out.set(index, [dx, dy]);
    else if (other === index) out.set(index, [((1 + fx) / 2) * dx, ((1 + fy) / 2) * dy]);
    else if (!all.has(other) || leads(mesh, index, other, held)) {
      out.set(index, [dx, dy]);
      out.set(other, [fx * dx, fy * dy]);
    }
  }
  return out;
}

function leads(mesh: Sides, index: number, other: number, held: number): boolean {
  const gap = distance(mesh, index, held) - distance(mesh, other, held);
  return gap === 0 ? index < other : gap < 0;
}

function distance({ columns }: Sides, p: number, q: number): number {
  return Math.hypot((p % columns) - (q % columns), Math.floor(p / columns) - Math.floor(q / columns));
}
