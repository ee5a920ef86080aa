/** Whether a bent shape is in one piece, from what is known of it before it is bent. */
import { type Told, type VerdictWords, verdictWords } from "#format/verdict";
import type { BendRoom3, SpaceBend } from "#wasm/api";

export interface BentWords extends VerdictWords {
  why: string;
}

const IMAGE =
  "A continuous image of a connected shape is connected (so the verdict goes along with the bend, and needs no search of its own).";
const CORNERS =
  "Every term of this bend is averaged where cells of neighbouring pieces share corners, and goes on between them without a jump, so that the whole of it is continuous; corners count as shared where they agree to a billionth of the shape’s size.";
const PLAIN = "With nothing shuffled the bend is a polynomial of the place, and so continuous.";
const TORN =
  "Where pieces meet, a point has several addresses, and the shuffle of letters takes each of them to a place of its own: the shape is torn there unless these agree. To hold it together everywhere is what Fujimoto and others call a connected IST and leave open; Frond does where pieces meet in corners. With the locality as large as the detail nothing is shuffled, and nothing tears.";

/** `before` is what is known of the shape before; null while it is not. */
export function bentWords(
  before: Told | null,
  { kb, ke, moves }: Pick<SpaceBend, "kb" | "ke" | "moves">,
  { continuous }: Pick<BendRoom3, "continuous">,
): BentWords {
  const words = verdictWords(before);
  if (moves.every((by) => by.every((x) => x === 0))) {
    return { ...words, why: "Its lattice is at rest: it is the shape as it was made." };
  }
  const plain = kb >= ke;
  if (!continuous && !plain) {
    return { tone: "unknown", text: "Not known", aside: "codes may tear it", why: TORN };
  }
  const whole = plain ? PLAIN : CORNERS;
  switch (before?.verdict) {
    case "connected":
      return {
        tone: "whole",
        text: "In one piece",
        aside: "as before it was bent",
        why: `${whole} ${IMAGE}`,
      };
    case "touching":
      return {
        ...words,
        aside: "before it was bent; it tears nothing",
        why: `${whole} Whether the shape is in one piece was not proved before it was bent, so it is not now.`,
      };
    case "disconnected":
      return {
        tone: "unknown",
        text: "Not known",
        aside: "in pieces before, which a fold may join",
        why: `${whole} It tears nothing more, but where it folds the shape over, pieces that were apart may meet.`,
      };
    default:
      return { ...words, why: whole };
  }
}
