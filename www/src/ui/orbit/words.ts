/** What is said of a point that is followed, and of the cell that it is to reach. */
import { formatNumber } from "#format/numbers";
import type { Point } from "#geometry/maps/orbit";
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
  return names.length < 2 ? names.join("") : `${names.slice(0, -1).join(", ")} and ${names.at(-1)}`;
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
      ? `The point ${pointText(here)} has no address that could be found: too many pieces overlap near it.`
      : `The point ${pointText(here)} is off the shape, ${formatNumber(off, 3)} from it. Only points of the shape have an address.`;
  if (orbit.way === "apply") {
    const where =
      off === null
        ? ""
        : off === 0
          ? " It is on the shape, and stays there."
          : ` It is off the shape, ${formatNumber(off, 3)} from it. The maps lead it to the shape all the same.`;
    if (last === undefined) return `The point starts at ${pointText(here)}.${where}`;
    const full = isFull(orbit) ? ` ${MOST_STEPS} steps are kept: start again.` : "";
    return `Step ${steps}: map ${last + 1}, to ${pointText(here)}.${full}`;
  }
  const several =
    pieces.length > 1
      ? ` Pieces ${listed(pieces)} share the point, so it has several addresses. The first is taken.`
      : "";
  if (last === undefined) return `The point ${pointText(here)} is on the shape.${several}`;
  const flat = isFlat(last)
    ? ` Map ${last + 1} flattens the shape, so it has no inverse: one of the points that it brings here is taken.`
    : "";
  const full = isFull(orbit) ? " More letters are finer than numbers tell apart." : "";
  return `Letter ${steps} is ${last + 1}: the point lies in piece ${last + 1}. The inverse of map ${last + 1} takes it to ${pointText(here)}.${several}${flat}${full}`;
}

/** What those who hear it are told of a step: what is new comes first, the whole address last. */
export function orbitSpoken(orbit: Orbit, followed: Followed, words: string): string {
  const { address } = followed;
  if (address.length === 0) return words;
  const text = address
    .slice(0, SHOWN)
    .map((letter) => letter + 1)
    .join(" ");
  const more = address.length > SHOWN ? " and so on" : "";
  return `${words} ${orbit.way === "read" ? "Address so far" : "Address"}: ${text}${more}.`;
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
  const count = throws === 1 ? "1 throw" : `${throws} throws`;
  const address = target.map((letter) => letter + 1).join(" ");
  const backwards = way.length === target.length && target.length > 1;
  if (shown && reached) {
    const order = way.map((letter) => letter + 1).join(", then ");
    const why = backwards ? "Read backwards, that is the address of the cell:" : "The cell has the address";
    return `One way: ${order}. ${why} ${address}.`;
  }
  if (!reached && throws >= MOST_THROWS) return `${count} are as many as are kept. Start again.`;
  if (!reached) return throws === 0 ? "No throw yet." : `${count}. The point is not in the framed cell yet.`;
  if (throws > least) return `Reached in ${count}. It can be done in fewer: start again.`;
  const why = backwards ? " Compare it with your throws." : "";
  return `Well done: reached in ${count}, and fewer do not get there. The cell has the address ${address}.${why}`;
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
  if (game.throws === 0)
    return `The framed cell is ${formatNumber(width, 3)} wide, with its centre at ${middle}. ${words} The point is at ${pointText(here)}.`;
  const sought = game.reached ? "" : ` The centre of the cell is at ${middle}.`;
  return `${words} The point is at ${pointText(here)}.${sought}`;
}
