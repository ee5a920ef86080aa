/** Other ways to bring two shapes together, in words. */
import { decompose } from "#geometry/maps/affine2";
import type { PathPlan, Route } from "#wasm/api";
import { shareWords } from "./verdict";

/** What a way would do with shape `b`, in one line, and why. Null is the present one, with the third parameter. */
export function offerWords(
  way: Pick<Route, "kind" | "about" | "place"> | null,
  plan: Pick<PathPlan, "holds" | "gap">,
  gap: number,
  b: string,
): { what: string; why: string } {
  const why = way === null ? "The stretch then runs ahead of the turn, or behind it." : way.about;
  if (!plan.holds)
    return { what: `Another path has a narrower gap: ${shareWords(plan.gap)}, not ${shareWords(gap)}.`, why };
  // Joints of doubles meet within some 1e-15 of the diameter, and no bound says that they do exactly.
  const but = way?.kind === "joints" ? ", up to rounding" : "";
  return { what: `${doing(way, b)} keeps the morph in one piece${but}.`, why };
}

/** Degrees that nobody sees. */
const UNSEEN = 2;

/** What is done on a way. */
function doing(way: Pick<Route, "kind" | "place"> | null, b: string): string {
  if (way === null) return "A third parameter";
  const turn = way.place ? Math.round(Math.abs(decompose(way.place).turn)) : 0;
  const turned = turn < UNSEEN ? null : `rotating ${b} by ${turn}°`;
  if (way.kind === "place") return turned ? upper(turned) : `Moving ${b}`;
  const first = DOING[way.kind] ?? "Another path";
  return turned ? `${first} and ${turned}` : first;
}

const upper = (words: string) => words.charAt(0).toUpperCase() + words.slice(1);

const DOING: Partial<Record<Route["kind"], string>> = {
  joints: "Matching joint by joint",
  correspondence: "Matching the maps differently",
  symmetry: "Using a symmetry of the shape",
  mirror: "Morphing to the mirror image",
  refine: "Splitting the pieces differently",
  double: "Counting another piece twice",
};

/** What was tried where nothing holds. */
export function triedWords({
  done,
  of,
  problem,
  best,
}: {
  done: number;
  of: number | null;
  problem: string | null;
  best: unknown;
}): string {
  if (problem !== null) return `Frond could not look for other paths: ${problem}`;
  if (done === 0) return "Frond tried no other path.";
  const all = of !== null && done < of ? `${done} of ${of} other paths` : `${done} other paths`;
  const none = `Frond tried ${all}: none stays in one piece`;
  return best ? `${none}.` : `${none}, or has a narrower gap.`;
}
