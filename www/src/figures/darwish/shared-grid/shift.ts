/** The shift of the second shape: a fraction, and what it may become. */
import type { Box } from "#geometry/boxes";
import { type Field, list, only, whole } from "../../kit/state/fields";

/** The numerators, and the denominator that both have. */
export type Shift = readonly [x: number, y: number, over: number];

/** The finest that is offered. */
export const MOST_OVER = 1000;
const MOST = 20 * MOST_OVER;

export const SHIFT: Field<Shift> = only(
  list(whole(-MOST, MOST), 3, 3) as Field<Shift>,
  ([, , over]) => over >= 1 && over <= MOST_OVER,
);

/** How far the second may go for the two still to reach each other, in numerators: along x, and along y. */
export function ranges(first: Box, second: Box, over: number): readonly [low: number, high: number][] {
  // A hull is drawn a little too large.
  const room = 1e-6;
  const range = (low: number, high: number): [number, number] => [
    Math.ceil((low - room) * over),
    Math.floor((high + room) * over),
  ];
  return [
    range(first.x0 - second.x1, first.x1 - second.x0),
    range(first.y0 - second.y1, first.y1 - second.y0),
  ];
}

/** As near as another denominator comes. */
export function rescaled([x, y, over]: Shift, next: number): Shift {
  const at = (p: number) => Math.round((p * next) / over) + 0;
  return [at(x), at(y), next];
}

/** The same within ranges. */
export function held([x, y, over]: Shift, [across, up]: readonly (readonly [number, number])[]): Shift {
  const within = (p: number, range: readonly [number, number] = [0, 0]) =>
    Math.min(range[1], Math.max(range[0], p)) + 0;
  return [within(x, across), within(y, up), over];
}

/** 1/4, −2/3, 5. */
export function fraction(p: number, over: number): string {
  const shared = Math.abs(gcd(p, over));
  const [top, bottom] = [p / shared, over / shared];
  return `${top < 0 ? "−" : ""}${Math.abs(top)}${bottom === 1 ? "" : `/${bottom}`}`;
}

/** A shift in words: on a line one fraction, else two. */
export function shiftWords([x, y]: readonly [number, number], over: number, isLine: boolean): string {
  return isLine ? fraction(x, over) : `(${fraction(x, over)}, ${fraction(y, over)})`;
}

const gcd = (a: number, b: number): number => (b === 0 ? a : gcd(b, a % b));
