import type { MapRow } from "./api";

/** Whether two shapes are made by the same maps, in the same order. */
export function sameMaps(p: readonly MapRow[], q: readonly MapRow[]): boolean {
  return p === q || (p.length === q.length && p.every((row, i) => row.every((x, k) => x === q[i]?.[k])));
}
