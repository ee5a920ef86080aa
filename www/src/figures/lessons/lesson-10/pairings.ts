/** All pairings of three pieces with three, and what the exercises ask of them. */

export type Pairing = readonly [number, number, number];

export const PAIRINGS: readonly Pairing[] = [
  [0, 1, 2],
  [1, 0, 2],
  [0, 2, 1],
  [2, 1, 0],
  [1, 2, 0],
  [2, 0, 1],
];

export const nameOf = (pairing: Pairing) => pairing.map((to) => to + 1).join("");

/** How many pieces keep their number: 3, 1 where two change places, or 0. */
export const kept = (pairing: Pairing) => pairing.filter((to, from) => to === from).length;

/**
 * Piece 2 of Heighway's dragon turns by half a turn, which is as short either way. Here it does so counter-clockwise:
 * so only one of the pairings that are asked about holds.
 */
export const TURNS = [0, 1, 0];
