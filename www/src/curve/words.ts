/** What is said of closed curves. */
import type { Curve } from "#wasm/api";

/** How much a curve is made of. */
export function sizeWords({ knots, edges }: Curve): string {
  const copies = edges.filter((edge) => edge !== null).length;
  const about = `${knots.length} ${knots.length === 1 ? "knot" : "knots"}`;
  return copies === 0 ? about : `${about}, ${copies} ${copies === 1 ? "copy" : "copies"}`;
}

/** How often a curve crosses itself; nothing where it does not. */
export function crossingWords(crossings: number): string {
  if (crossings <= 0) return "";
  if (crossings === 1) return "crosses itself once";
  return crossings === 2 ? "crosses itself twice" : `crosses itself ${crossings} times`;
}

/** Why it is in one piece, in a sentence or two. */
export function whyWords(ends: { a: string; b: string } | null): string {
  const edges =
    "Every edge, straight or a smaller copy of an arc, runs from one knot to the next, and the last one meets the first.";
  const between = ends
    ? ` So it is at every moment between ${ends.a} and ${ends.b}, since the knots move and the edges go along.`
    : "";
  return `${edges} There is no place where it could come apart.${between}`;
}

/** What is true of the whole way, given how often the curve crosses itself where it does so most. */
export function wayWords(worst: number): string {
  return worst > 0
    ? `An outline made of smaller copies of its own arcs. It stays one closed curve, but on the way it ${crossingWords(worst).replace("itself", "itself,")} where it does most: parts of it lie over others.`
    : "An outline made of smaller copies of its own arcs. Knots move, edges go along, and nothing can come apart.";
}

/** Where too few knots have a partner for the way to look like one leaf that changes: what helps. */
export function unlikeWords(a: number, b: number, both: number, worst: number): string | null {
  const met = a + b - both;
  if (worst === 0 || met > Math.min(a, b) / 4) return null;
  return "So few have partners that one outline shrinks while the other grows. A stalk on one of them is the usual reason: Fit takes it off, in step 1 of a photograph.";
}

/** How the knots of two curves were brought together, given how many there are in common. */
export function matchWords(a: number, b: number, both: number): string {
  const met = a + b - both;
  if (met <= 0) return `${both} knots on the way.`;
  const [alone, others] = [a - met, b - met];
  const rest =
    alone + others === 0
      ? "Every knot has its partner."
      : `${alone + others === 1 ? "One" : alone + others} of one shape alone ${
          alone + others === 1 ? "opens from an edge or closes" : "open from an edge or close"
        } into one.`;
  return `${met} knots of A become knots of B. ${rest}`;
}
