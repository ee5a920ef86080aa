/** Other ways to bring two shapes together, in words. */
import { decompose } from "#geometry/maps/affine2";
import type { PathPlan, Route } from "#wasm/api";
import { shareWords } from "./verdict";

/** What a way that was found is worth, and why. Null is the present one, with the third parameter. */
export function offerWords(
  way: Pick<Route, "kind" | "about"> | null,
  plan: Pick<PathPlan, "holds" | "gap">,
  gap: number,
): { what: string; why: string } {
  const why = way === null ? "The stretch then runs ahead of the turn, or behind it." : way.about;
  if (!plan.holds)
    return { what: `Another way breaks less: ${shareWords(plan.gap)}, not ${shareWords(gap)}.`, why };
  // Joints of doubles meet within some 1e-15 of the diameter, and no bound says that they do exactly.
  if (way?.kind === "joints")
    return { what: "Joint by joint it holds together all the way, but for rounding.", why };
  if (way === null) return { what: "With a third parameter it holds together.", why };
  return { what: `${NAMES[way.kind] ?? "Another way"} it holds together.`, why };
}

/** Degrees that nobody sees. */
const UNSEEN = 2;

/** That the last shape does not stand as it was chosen, where a way had to lay it otherwise; empty where it stays. */
export function turnedWords(name: string, { place }: Pick<Route, "place">): string {
  const turn = place ? Math.abs(decompose(place).turn) : 0;
  return turn < UNSEEN ? "" : ` ${name} is turned by ${Math.round(turn)}° for it.`;
}

const NAMES: Partial<Record<Route["kind"], string>> = {
  correspondence: "Matched otherwise",
  place: "With shape B laid elsewhere",
  symmetry: "Through a symmetry",
  mirror: "Towards the mirror image",
  refine: "With its pieces split otherwise",
  double: "With another piece counted twice",
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
  if (problem !== null) return `Other ways could not be looked for: ${problem}`;
  if (done === 0) return "No other way was tried.";
  const all =
    of !== null && done < of ? `${done} of ${of} other ways were tried` : `${done} other ways were tried`;
  return best ? `${all}: none of them holds.` : `${all}: none of them holds, or breaks less.`;
}
