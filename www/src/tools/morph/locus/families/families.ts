/** What is known by proof of the polygon families {s z + exp(2 pi i k / n)}. */

import { isPrime } from "#geometry/maps/polygon-family";
import type { Uv } from "#geometry/path";
import * as messages from "../messages";

/** Circles about 0 that tell something. */
export function circlesOf(sides: number): { radius: number; name: string; kind: "one" | "area" | "line" }[] {
  return [
    { radius: 1, name: "|s| = 1", kind: "one" },
    { radius: 1 / Math.sqrt(sides), name: `1/√${sides}`, kind: "area" },
    { radius: 1 / sides, name: `1/${sides}`, kind: "line" },
  ];
}

/** How the map is read. */
export function familyWords(sides: number): string {
  const copies = sides === 2 ? messages.twoCopiesItself : messages.copiesOnPolygon(sides);
  const name = sides === 2 ? messages.paleSetCalledM : "";
  return messages.pointIs(copies, name);
}

/**
 * What others proved and what Frond computes. The pieces are turned into each other by n-th of a turn; so if n is prime
 * and any two meet, all hang together.
 */
export function theoremWords(sides: number): string[] {
  const outside = isPrime(sides) ? messages.alwaysOutside(sides) : messages.someMeetOutside(sides);
  return [outside, messages.neverInside(sides), messages.betweenTwoCirclesNo];
}

export function symmetryWords(sides: number): string {
  return sides === 2 ? messages.oppositeSameShape : messages.sameShapes(sides);
}

/** Other parameters with the same shape, or with its mirror image. */
export function twins(sides: number, [x, y]: Uv): Uv[] {
  const found: Uv[] = [];
  if (sides > 12) return found;
  for (let k = 0; k < sides; k++) {
    const [c, s] = [Math.cos((2 * Math.PI * k) / sides), Math.sin((2 * Math.PI * k) / sides)];
    for (const sign of [1, -1]) {
      const at: Uv = [x * c - sign * y * s, x * s + sign * y * c];
      if (found.concat([[x, y]]).every((p) => Math.hypot(p[0] - at[0], p[1] - at[1]) > 1e-9)) found.push(at);
    }
  }
  return found;
}
