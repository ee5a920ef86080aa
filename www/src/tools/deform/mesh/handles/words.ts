/** What is said of control points. */

import { formatNumber } from "#format/numbers";
import type { Mesh } from "#geometry/mesh";
import * as messages from "../../messages";

/** "Column 2, row 3": counted from the left and from below. */
export function nameOf({ columns }: Pick<Mesh, "columns">, index: number): string {
  return messages.columnAndRow((index % columns) + 1, Math.floor(index / columns) + 1);
}

/** "moved 0.12 right, 0.3 up". */
export function movedWords(dx: number, dy: number): string {
  const parts = [...way(dx, "right", "left"), ...way(dy, "up", "down")];
  return parts.length === 0 ? messages.atRest : messages.movedBy(parts.join(", "));
}

function way(length: number, forth: string, back: string): string[] {
  const size = Math.abs(length);
  if (!(size > 0)) return [];
  const digits = Math.max(2, Math.min(8, 1 - Math.floor(Math.log10(size))));
  return [`${formatNumber(size, digits)} ${length > 0 ? forth : back}`];
}

export function handleWords(mesh: Mesh, index: number): string {
  return `${nameOf(mesh, index)}: ${movedWords(mesh.moves[2 * index] ?? 0, mesh.moves[2 * index + 1] ?? 0)}`;
}
