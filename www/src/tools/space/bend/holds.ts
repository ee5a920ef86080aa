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
  "Where pieces meet, a point has several addresses, and the shuffle of letters takes each of them to a place of its own: the shape is torn there unless these agree. To hold it together everywhere is what Fujimoto and others call a connected IST and leave open; Frond does where pieces meet in corners. With the locality as large as the detail, or no roughness, nothing is shuffled, and nothing tears.";
const ONE_TO_ONE =
  "Its lattice moves no two points further towards each other than part of the way between them, so that the bend takes no two points to one: it joins nothing, and the verdict goes along with it both ways.";

/** What says how a shape is bent. */
export type Bending = Pick<SpaceBend, "sizes" | "moves" | "kb" | "ke" | "delta" | "spin">;

/** No roundings of some hundred numbers add up to more. */
const ROUNDED_UP = 1 + 1e-9;

/**
 * Whether nothing is shuffled, so that the bend is the polynomial of its lattice (Fujimoto et al., eqs 12, 13 and 19).
 * The term of kb leaves all letters where they are, and so does that of kb + 1, which turns its displacement where
 * displacements turn; without roughness no other term than the first counts.
 */
export function isPlain({ kb, ke, delta, spin }: Bending, deepest: number): boolean {
  const last = Math.min(ke, deepest);
  const exact = spin === "none" ? 2 : 1;
  return delta === 0 || Math.ceil(last) < Math.floor(Math.min(kb, last)) + exact;
}

/** Whether all is moved as one: every term of the bend is the same shift then. */
function isShift({ moves, spin }: Bending): boolean {
  const [first] = moves;
  return spin === "none" && moves.every((by) => by.every((x, axis) => x === first?.[axis]));
}

/**
 * Whether the lattice moves no two points of the box towards each other by as much as they are apart: its derivative,
 * in Bernstein's form a mean of differences of neighbours, is below 1 everywhere.
 */
export function isOneToOne({ sizes, moves }: Bending, { min, max }: Pick<BendRoom3, "min" | "max">): boolean {
  const sides = max.map((x, axis) => x - (min[axis] ?? 0));
  const longest = Math.max(...sides);
  let squares = 0;
  let stride = 1;
  for (const [axis, size] of sizes.entries()) {
    let most = 0;
    for (const [i, by] of moves.entries()) {
      const next = moves[i + stride];
      if (Math.floor(i / stride) % size === size - 1 || !next) continue;
      most = Math.max(most, Math.hypot(...by.map((x, k) => (next[k] ?? 0) - x)));
    }
    squares += ((size - 1) * most * (longest / (sides[axis] ?? 1))) ** 2;
    stride *= size;
  }
  return Math.sqrt(squares) * ROUNDED_UP < 1;
}

/** `before` is what is known of the shape before; null while it is not. */
export function bentWords(before: Told | null, bend: Bending, room: BendRoom3): BentWords {
  const words = verdictWords(before);
  if (bend.moves.every((by) => by.every((x) => x === 0))) {
    return { ...words, why: "Its lattice is at rest: it is the shape as it was made." };
  }
  if (isShift(bend)) {
    return { ...words, why: "All of its lattice is moved alike: it is the shape as it was made, elsewhere." };
  }
  const plain = isPlain(bend, room.deepest);
  if (!room.continuous && !plain) {
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
      return plain && isOneToOne(bend, room)
        ? { tone: "broken", text: words.text, aside: "as before it was bent", why: `${PLAIN} ${ONE_TO_ONE}` }
        : {
            tone: "unknown",
            text: "Not known",
            aside: "in pieces before, which a fold may join",
            why: `${whole} It tears nothing more, but where it folds the shape over, pieces that were apart may meet.`,
          };
    default:
      return { ...words, why: whole };
  }
}
