/** What is said of a point that is followed, and of the cell that it is to reach. */
import { formatNumber } from "#format/numbers";
import { listOf } from "#format/plural";
import type { Point } from "#geometry/maps/orbit";
import * as messages from "../messages";
import { type Facts, type Followed, isFull, MOST_STEPS, type Orbit, stepsOf } from "./follow";

/** Letters that are shown of an address. */
const SHOWN = 12;

/** "1 3 2", with three dots where the address goes on; letters count from 1. */
export function addressText(letters: readonly number[], goesOn: boolean): string {
  const shown = letters.slice(0, SHOWN).map((letter) => letter + 1);
  const more = goesOn || letters.length > SHOWN;
  return [...shown, ...(more ? ["…"] : [])].join(" ");
}

export const pointText = ([x, y]: Point): string => `(${formatNumber(x, 3)}, ${formatNumber(y, 3)})`;

/** "1 and 2", "1, 2 and 5": counted from 1. */
export function listed(letters: readonly number[]): string {
  const names = letters.map((letter) => `${letter + 1}`);
  return listOf(names);
}

/** Where the point is and how it came there, in two or three short sentences. */
export function orbitWords(
  orbit: Orbit,
  followed: Followed,
  { off, pieces }: Facts,
  isFlat: (letter: number) => boolean,
): string {
  const here = followed.points.at(-1) ?? [0, 0];
  const last = followed.letters.at(-1);
  const steps = stepsOf(orbit);
  if (orbit.way === "off")
    return off === null
      ? messages.noAddress(pointText(here))
      : messages.offShape(pointText(here), formatNumber(off, 3));
  if (orbit.way === "apply") {
    const where =
      off === null ? "" : off === 0 ? messages.onShapeAndStays : messages.offButLed(formatNumber(off, 3));
    if (last === undefined) return messages.startsAt(pointText(here), where);
    const full = isFull(orbit) ? messages.stepsFull(MOST_STEPS) : "";
    return messages.stepTo(steps, last + 1, pointText(here), full);
  }
  const several = pieces.length > 1 ? messages.sharedPoint(listed(pieces)) : "";
  if (last === undefined) return messages.onShape(pointText(here), several);
  const flat = isFlat(last) ? messages.flatMap(last + 1) : "";
  const full = isFull(orbit) ? messages.moreDigitsFinerThan : "";
  return messages.digitIs(steps, last + 1, pointText(here), several + flat + full);
}

/** What those who hear it are told of a step: what is new comes first, the whole address last. */
export function orbitSpoken(orbit: Orbit, followed: Followed, words: string): string {
  const { address } = followed;
  if (address.length === 0) return words;
  const text = address
    .slice(0, SHOWN)
    .map((letter) => letter + 1)
    .join(" ");
  const more = address.length > SHOWN ? messages.andSoOn : "";
  return messages.addressIs(
    words,
    orbit.way === "read" ? messages.addressSoFar : messages.address,
    text,
    more,
  );
}

export interface Game {
  /** Throws that were made. */
  throws: number;
  reached: boolean;
  /** The fewest there are, from the start. */
  least: number;
  /** The way was shown, and not found. */
  shown: boolean;
  target: readonly number[];
  /** The throws of the fewest. */
  way: readonly number[];
  /** What the picture shows, for those who do not see it: the point, and the cell that it is to reach. */
  where?: { here: Point; centre: Point; width: number };
}

/** Throws that are kept in a game. */
export const MOST_THROWS = 40;

/** How the game stands. The address of the cell is told to whoever has found it, or asks. */
export function gameWords({ throws, reached, least, shown, target, way }: Game): string {
  const count = throws === 1 ? "1 throw" : messages.throwsOf(throws);
  const address = target.map((letter) => letter + 1).join(" ");
  const backwards = way.length === target.length && target.length > 1;
  if (shown && reached) {
    const order = way.map((letter) => letter + 1).join(", then ");
    const why = backwards ? messages.readBackwardsThisAddress : messages.cellHasAddress;
    return messages.oneSolution(order, why, address);
  }
  if (!reached && throws >= MOST_THROWS) return messages.throwsFull(count);
  if (!reached) return throws === 0 ? messages.noThrowYet : messages.notYet(count);
  if (throws > least) return messages.reachedButFewer(count);
  const why = backwards ? messages.compareWithYourThrows : "";
  return messages.wellDone(count, address, why);
}

/**
 * The same for those who hear it, with the places that others see: enough to play by, and not the letters. What is new
 * comes first: the cell at the beginning, and then how it goes.
 */
export function gameSpoken(game: Game): string {
  const words = gameWords(game);
  if (!game.where) return words;
  const { here, centre, width } = game.where;
  const middle = pointText(centre);
  if (game.throws === 0) return messages.framedCell(formatNumber(width, 3), middle, words, pointText(here));
  const sought = game.reached ? "" : messages.cellCentre(middle);
  return messages.wordsAndPoint(words, pointText(here), sought);
}
