/** Outlines of areas of equal samples. */

/** Right, down, left, up. */
const STEPS = [
  [1, 0],
  [0, 1],
  [-1, 0],
  [0, -1],
] as const;

/**
 * The outline of each class of cells of a grid, as closed polygons of cell corners, to be filled even-odd: x, y, x, y,
 * .. with a corner where they turn. They meet without a gap.
 */
export function outlinesOf(
  classes: ArrayLike<number>,
  width: number,
  height: number,
): Map<number, number[][]> {
  const found = new Map<number, number[][]>();
  const row = width + 1;
  for (const one of new Set(Array.from(classes))) {
    // At each corner, the steps that leave it with the class on the right hand: a bit each.
    const leave = new Uint8Array(row * (height + 1));
    const is = (x: number, y: number) =>
      x >= 0 && y >= 0 && x < width && y < height && classes[y * width + x] === one;
    for (let y = 0; y < height; y++) {
      for (let x = 0; x < width; x++) {
        if (!is(x, y)) continue;
        const at = y * row + x;
        if (!is(x, y - 1)) leave[at] = (leave[at] ?? 0) | 1;
        if (!is(x + 1, y)) leave[at + 1] = (leave[at + 1] ?? 0) | 2;
        if (!is(x, y + 1)) leave[at + row + 1] = (leave[at + row + 1] ?? 0) | 4;
        if (!is(x - 1, y)) leave[at + row] = (leave[at + row] ?? 0) | 8;
      }
    }
    const polygons: number[][] = [];
    for (let start = 0; start < leave.length; start++) {
      while (leave[start]) polygons.push(walk(leave, start, row));
    }
    found.set(one, polygons);
  }
  return found;
}

/** Once round, from a corner back to it; the steps are taken away. */
function walk(leave: Uint8Array, start: number, row: number): number[] {
  const corners: number[] = [];
  let [at, before] = [start, -1];
  do {
    const open = leave[at] ?? 0;
    const step = [0, 1, 2, 3].find((k) => open & (1 << k)) ?? 0;
    leave[at] = open & ~(1 << step);
    if (step !== before) corners.push(at % row, Math.floor(at / row));
    before = step;
    const [dx, dy] = STEPS[step] ?? [0, 0];
    at += dx + dy * row;
  } while (at !== start);
  return corners;
}
