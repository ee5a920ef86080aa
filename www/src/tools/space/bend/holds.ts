/** Whether a bent shape is in one piece, from what is known of it before it is bent. */
import { type Told, type VerdictWords, verdictWords } from "#format/verdict";
import type { BendRoom3, SpaceBend } from "#wasm/api";
import * as messages from "../messages";

export interface BentWords extends VerdictWords {
  why: string;
}

const IMAGE = messages.continuousImageConnectedShape;
const CORNERS = messages.everyTermThisDeformation;
const PLAIN = messages.withoutShufflingDeformationPolynomial;
const TORN = messages.wherePiecesMeetPoint;
const ONE_TO_ONE = messages.latticeMovesNoTwo;

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
    return { ...words, why: messages.latticeAtRestSo };
  }
  if (isShift(bend)) {
    return { ...words, why: messages.allLatticeMovesAlike };
  }
  const plain = isPlain(bend, room.deepest);
  if (!room.continuous && !plain) {
    return { tone: "unknown", text: messages.notKnown, aside: messages.codesMayTear, why: TORN };
  }
  const whole = plain ? PLAIN : CORNERS;
  switch (before?.verdict) {
    case "connected":
      return {
        tone: "whole",
        text: messages.inOnePiece,
        aside: messages.asWithoutDeformation,
        why: `${whole} ${IMAGE}`,
      };
    case "touching":
      return {
        ...words,
        aside: messages.withoutDeformationTearsNothing,
        why: messages.notProvedBefore(whole),
      };
    case "disconnected":
      return plain && isOneToOne(bend, room)
        ? {
            tone: "broken",
            text: words.text,
            aside: messages.asWithoutDeformation,
            why: `${PLAIN} ${ONE_TO_ONE}`,
          }
        : {
            tone: "unknown",
            text: messages.notKnown,
            aside: messages.inPiecesWhenUndeformed,
            why: messages.foldMayJoin(whole),
          };
    default:
      return { ...words, why: whole };
  }
}
