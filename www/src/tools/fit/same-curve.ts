/** Curves come from the worker anew at each step of progress, whether they are better or not. */
import type { Curve } from "#wasm/api";

export function sameCurve(a: Curve, b: Curve): boolean {
  return a === b || JSON.stringify(a) === JSON.stringify(b);
}

/** What is reached: the one before where the next is the same, so that whoever draws it has nothing to do. */
export function reached<T extends { of: unknown; numbers: number; curve: Curve }>(
  last: T | null,
  next: T,
): T {
  if (last === null || last.of !== next.of || last.numbers !== next.numbers) return next;
  return sameCurve(last.curve, next.curve) ? last : next;
}
