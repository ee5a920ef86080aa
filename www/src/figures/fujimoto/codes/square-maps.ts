/** Squares as attractors of systems of maps, with the codes of the unit cubes. */
import type { MapRow } from "#wasm/api";

/** The unit square in parts by parts smaller ones, from left to right and then upwards. */
export function squareMaps(parts: number): MapRow[] {
  const side = 1 / parts;
  return Array.from({ length: parts * parts }, (_, letter): MapRow => {
    return [side, 0, 0, side, (letter % parts) * side, Math.floor(letter / parts) * side];
  });
}
