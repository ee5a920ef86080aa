/** Other ways to bring two shapes together, in words. */
import { decompose } from "#geometry/maps/affine2";
import type { PathPlan, Route } from "#wasm/api";
import * as messages from "./messages";
import { shareWords } from "./verdict";

/** What a way would do with shape `b`, in one line, and why. Null is the present one, with the third parameter. */
export function offerWords(
  way: Pick<Route, "kind" | "about" | "place"> | null,
  plan: Pick<PathPlan, "holds" | "gap">,
  gap: number,
  b: string,
): { what: string; why: string } {
  const why = way === null ? messages.stretchThenLeadsOr : way.about;
  if (!plan.holds) return { what: messages.narrowerGap(shareWords(plan.gap), shareWords(gap)), why };
  // Joints of doubles meet within some 1e-15 of the diameter, and no bound says that they do exactly.
  const but = way?.kind === "joints" ? messages.upToRounding : "";
  return { what: messages.keepsInOnePiece(doing(way, b), but), why };
}

/** Degrees that nobody sees. */
const UNSEEN = 2;

/** What is done on a way. */
function doing(way: Pick<Route, "kind" | "place"> | null, b: string): string {
  if (way === null) return messages.thirdParameter;
  const turn = way.place ? Math.round(Math.abs(decompose(way.place).turn)) : 0;
  const turned = turn < UNSEEN ? null : messages.rotating(b, turn);
  if (way.kind === "place") return turned ? upper(turned) : messages.moving(b);
  const first = DOING[way.kind] ?? messages.anotherPath;
  return turned ? messages.bothChanges(first, turned) : first;
}

const upper = (words: string) => words.charAt(0).toUpperCase() + words.slice(1);

const DOING: Partial<Record<Route["kind"], string>> = {
  joints: messages.pairingJointByJoint,
  correspondence: messages.pairingMapsDifferently,
  symmetry: messages.usingSymmetryShape,
  mirror: messages.morphingToMirrorImage,
  refine: messages.splittingPiecesDifferently,
  double: messages.usingAnotherPieceTwice,
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
  if (problem !== null) return messages.couldNotSearch(problem);
  if (done === 0) return messages.frondTriedNoOther;
  const all = of !== null && done < of ? messages.someTried(done, of) : messages.allTried(done);
  const none = messages.noneStays(all);
  return best ? `${none}.` : messages.orNarrower(none);
}
