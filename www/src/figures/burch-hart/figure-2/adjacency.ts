/** The overlap graph as a matrix, and what its powers tell (Burch & Hart 1997, Definition 4 and Theorem 3). */

type Matrix = number[][];

/** 1 where two of so many pieces meet, and on the diagonal, where the algorithm of the paper begins with X = I. */
export function adjacency(count: number, edges: readonly (readonly [number, number])[]): Matrix {
  const rows: Matrix = Array.from({ length: count }, (_, i) =>
    Array.from({ length: count }, (_, j) => (i === j ? 1 : 0)),
  );
  for (const [i, j] of edges) {
    const [a, b] = [rows[i], rows[j]];
    if (a && b) [a[j], b[i]] = [1, 1];
  }
  return rows;
}

/** X + X² + .. + X^(N - 1) of an N x N matrix: a 0 stands where no way leads. */
export function ways(x: Matrix): Matrix {
  const count = x.length;
  const at = (of: Matrix, i: number, j: number) => of[i]?.[j] ?? 0;
  const times = (a: Matrix, b: Matrix): Matrix =>
    a.map((row) => x.map((_, j) => row.reduce((sum, value, k) => sum + value * at(b, k, j), 0)));
  let power = x;
  let sum = x;
  for (let n = 2; n < count; n++) {
    power = times(power, x);
    const next = power;
    sum = sum.map((row, i) => row.map((value, j) => value + at(next, i, j)));
  }
  return sum;
}
