/** What is proved of the polygon families, {s z + e^(2 pi i k / n)}, without looking. */
import type { Connectedness } from "#wasm/api";
import * as messages from "../messages";

export const isPrime = (n: number): boolean => {
  for (let d = 2; d * d <= n; d++) if (n % d === 0) return false;
  return n > 1;
};

/** Rounding of s and of the sum of its squares is less. */
const SURE = 1 + 1e-14;

/**
 * Whether the shape of s must be in one piece: n |s|² >= 1, and n is prime.
 *
 * Were all pieces apart, a small enough neighbourhood of the shape would hold its n disjoint images and more, so that n
 * |s|² < 1. So some two meet; the n-ths of a turn take the shape into itself and pieces into pieces, and where n is
 * prime, these two turned round reach every piece.
 */
export function fills(sides: number, [re, im]: readonly [number, number, number?]): boolean {
  return isPrime(sides) && sides * (re * re + im * im) >= SURE;
}

/** The answer with what is known of the family: it may say more than a search through pieces. */
export function answerOf(
  found: Connectedness,
  sides: number,
  s: readonly [number, number, number?],
): Connectedness {
  if (found.verdict === "connected" || found.verdict === "no-attractor" || !fills(sides, s)) return found;
  return {
    ...inOnePiece(found),
    reason: {
      kind: "area",
      text: messages.polygonFills(sides),
      links: [],
      assuming: [],
    },
  };
}

/** The answer about a shape that is proved to be in one piece after all. */
export function inOnePiece({ closest: _, reason: __, ...found }: Connectedness): Connectedness {
  return {
    ...found,
    verdict: "connected",
    gap: { lower: 0, upper: 0 },
    components: found.components.map(() => 0),
    count: 1,
  };
}
