/** Fits within so many bytes as closed curves of corners alone. */
import type { Curve } from "#wasm/api";
import { rough } from "#wasm/curve";

/** The last ones are remembered: shelves ask again and again. */
const MOST = 8;
const made = new Map<string, Curve>();

/** The curve of a word with short straight sides in place of its parabolas, as the morph and the grid take it. */
export function polygonOf(word: string): Curve {
  const before = made.get(word);
  if (before) return before;
  const curve = rough.splineCurve(word);
  made.set(word, curve);
  for (const old of made.keys()) {
    if (made.size <= MOST) break;
    made.delete(old);
  }
  return curve;
}
