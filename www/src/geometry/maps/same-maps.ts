/** Whether two shapes, of the plane or of space, are made by the same maps, in the same order. */
export function sameMaps(p: readonly (readonly number[])[], q: readonly (readonly number[])[]): boolean {
  return p === q || (p.length === q.length && p.every((row, i) => row.every((x, k) => x === q[i]?.[k])));
}
