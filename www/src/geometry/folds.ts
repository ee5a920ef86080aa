/** Where a bend turns the plane, or space, over: there what it bends lies mirrored, over other parts of it. */
import * as messages from "./messages";

/** Places that are looked at along each side, and half the step of a difference. */
const LOOKS = 9;
const STEP = 1e-4;

/**
 * The part of a box, 0 to 1, in which a map of it reverses orientation, looked for at 9 places along each side. `map`
 * takes a place of the box, 0 to 1 along each side, to where it goes.
 */
export function foldedPart(sides: 2 | 3, map: (place: readonly number[]) => readonly number[]): number {
  const count = LOOKS ** sides;
  let over = 0;
  for (let i = 0; i < count; i++) {
    const place = Array.from({ length: sides }, (_, k) => (Math.floor(i / LOOKS ** k) % LOOKS) / (LOOKS - 1));
    const rows = place.map((_, k) => {
      const moved = (by: number) => map(place.map((x, axis) => (axis === k ? x + by : x)));
      const [ahead, behind] = [moved(STEP), moved(-STEP)];
      return ahead.map((x, axis) => x - (behind[axis] ?? 0));
    });
    if (determinant(rows) < 0) over++;
  }
  return over / count;
}

function determinant(rows: readonly (readonly number[])[]): number {
  const [a = [], b = [], c] = rows;
  const minor = (i: number, j: number, [p, q]: readonly [readonly number[], readonly number[]]) =>
    (p[i] ?? 0) * (q[j] ?? 0) - (p[j] ?? 0) * (q[i] ?? 0);
  if (!c) return minor(0, 1, [a, b]);
  return (
    (a[0] ?? 0) * minor(1, 2, [b, c]) - (a[1] ?? 0) * minor(0, 2, [b, c]) + (a[2] ?? 0) * minor(0, 1, [b, c])
  );
}

/** The Bernstein polynomials of degree `count - 1`. */
export function bernstein(t: number, count: number): number[] {
  const values = [1];
  for (let degree = 1; degree < count; degree++) {
    let carry = 0;
    for (let k = 0; k <= degree; k++) {
      const here = values[k] ?? 0;
      values[k] = here * (1 - t) + carry;
      carry = here * t;
    }
  }
  return values;
}

/** What is said of it; nothing where nothing is turned over. */
export function foldedWords(part: number, back: string): string | null {
  if (part === 0) return null;
  const percent = Math.max(1, Math.round(100 * part));
  return percent > 99 ? messages.allInsideOut(back) : messages.foldedOver(percent, back);
}
