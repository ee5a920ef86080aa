/** A point that is followed: under maps that are applied to it, or back through the pieces that it lies in. */
import type { Box } from "#geometry/boxes";
import { addressOf, nearestOn, orbitOf, type Point, piecesAt, pointAt } from "#geometry/maps/orbit";
import type { MapRow } from "#wasm/api";

/**
 * What is followed. Of a point of the shape its address is kept, and not its place: so it stays a point of the shape
 * while the maps change, and no map has to be inverted, which loses digits, and cannot be done where a map is flat.
 */
export type Orbit =
  | { way: "apply"; start: Point; letters: readonly number[] }
  | { way: "read"; address: readonly number[]; count: number }
  /**
   * An address was asked for where the shape is not: the nearest point that is on it, where that is known. So many
   * letters are read again where the point comes back.
   */
  | { way: "off"; at: Point; distance: number; nearest: readonly number[] | null; count: number };

/** Steps that are kept. */
export const MOST_STEPS = 500;
/** Letters that are read: smaller pieces are smaller than what numbers tell apart. */
export const MOST_READ = 20;
/** Within such a part of its size a point counts as on the shape: that is less than the eye sees. */
const ON = 1e-3;

export interface Followed {
  points: readonly Point[];
  /** The map of each step. */
  letters: readonly number[];
  /** As far as it is known, from the largest piece to the smallest. */
  address: readonly number[];
}

/** The way of the point. Maps that are gone end it. */
export function follow(maps: readonly MapRow[], orbit: Orbit): Followed {
  switch (orbit.way) {
    case "apply": {
      const points = orbitOf(maps, orbit.start, orbit.letters);
      const letters = orbit.letters.slice(0, points.length - 1);
      return { points, letters, address: addressOf(letters) };
    }
    case "read": {
      const gone = orbit.address.findIndex((letter) => letter >= maps.length);
      const whole = gone < 0 ? orbit.address : orbit.address.slice(0, gone);
      const letters = whole.slice(0, orbit.count);
      // By what is left of the address: each letter that is read drops out in front.
      const points = Array.from({ length: letters.length + 1 }, (_, k) => pointAt(maps, whole.slice(k)));
      return { points, letters, address: letters };
    }
    case "off":
      return { points: [orbit.at], letters: [], address: [] };
  }
}

const sizeOf = (box: Box): number => Math.hypot(box.x1 - box.x0, box.y1 - box.y0);

/**
 * Another point, in the same way. One that is within `reach` of the shape is taken onto it where its address is to be
 * read; so many letters as were read before are read again.
 */
export function choose(
  orbit: Orbit,
  maps: readonly MapRow[],
  box: Box,
  point: Point,
  reach = ON * sizeOf(box),
): Orbit {
  if (orbit.way === "apply") return { ...orbit, start: point };
  const found = nearestOn(maps, box, point);
  const { count } = orbit;
  if (found && found.distance <= Math.max(reach, ON * sizeOf(box)))
    return { way: "read", address: found.address, count: Math.min(count, found.address.length) };
  const distance = found?.sure ? found.distance : Number.NaN;
  return { way: "off", at: point, distance, nearest: found?.address ?? null, count };
}

/** The other way, from where the point is now. */
export function turnTo(
  way: "apply" | "read",
  orbit: Orbit,
  maps: readonly MapRow[],
  box: Box,
  reach?: number,
): Orbit {
  const now = orbit.way === "off" ? "read" : orbit.way;
  if (now === way) return orbit;
  const start = follow(maps, orbit).points.at(-1) ?? [0, 0];
  if (way === "apply") return { way, start, letters: [] };
  return choose({ way: "read", address: [], count: 0 }, maps, box, start, reach);
}

/** How far it can go on. */
export const isFull = (orbit: Orbit): boolean =>
  orbit.way === "off" ||
  (orbit.way === "apply"
    ? orbit.letters.length >= MOST_STEPS
    : orbit.count >= Math.min(MOST_READ, orbit.address.length));

/** One map more. */
export function applied(orbit: Orbit, letter: number): Orbit {
  if (orbit.way !== "apply" || isFull(orbit)) return orbit;
  return { ...orbit, letters: [...orbit.letters, letter] };
}

/** One letter more. */
export function readOn(orbit: Orbit): Orbit {
  return orbit.way !== "read" || isFull(orbit) ? orbit : { ...orbit, count: orbit.count + 1 };
}

/** One step back. */
export function back(orbit: Orbit): Orbit {
  if (orbit.way === "apply") return { ...orbit, letters: orbit.letters.slice(0, -1) };
  return orbit.way === "read" ? { ...orbit, count: Math.max(0, orbit.count - 1) } : orbit;
}

/** All steps back. */
export function startAgain(orbit: Orbit): Orbit {
  if (orbit.way === "apply") return { ...orbit, letters: [] };
  return orbit.way === "read" ? { ...orbit, count: 0 } : orbit;
}

export const stepsOf = (orbit: Orbit): number =>
  orbit.way === "apply" ? orbit.letters.length : orbit.way === "read" ? orbit.count : 0;

/** What is true of the point now, besides its address. */
export interface Facts {
  /** How far the start is from the shape; 0 on it, null where that is not known. */
  off: number | null;
  /** The pieces that the point lay in when its last letter was read, or lies in, where none was. */
  pieces: readonly number[];
}

export function factsOf(maps: readonly MapRow[], box: Box, orbit: Orbit): Facts {
  if (orbit.way === "off") return { off: Number.isNaN(orbit.distance) ? null : orbit.distance, pieces: [] };
  const { points } = follow(maps, orbit);
  if (orbit.way === "read") {
    const before = points.at(orbit.count === 0 ? 0 : -2) ?? points[0];
    return { off: 0, pieces: before ? piecesAt(maps, box, before) : [] };
  }
  // After a step nobody asks, and it is not to be found out again at each.
  if (orbit.letters.length > 0) return { off: null, pieces: [] };
  const found = nearestOn(maps, box, orbit.start);
  if (found && found.distance <= ON * sizeOf(box)) return { off: 0, pieces: [] };
  return { off: found?.sure ? found.distance : null, pieces: [] };
}
