/**
 * Symmetries of an attractor that its maps show: a rotation or mirroring g for which each g w g^-1 is one of the maps
 * again, so that g takes the attractor to itself (Hutchinson 1981, 3.1: it is the only set that the maps make of
 * itself). There may be others, which no permutation of the maps shows: none is ruled out.
 */
import type { MapRow } from "#wasm/api";
import { after2 } from "./affine2";

export interface Symmetries {
  /** How often it comes to itself in a full turn: 1 where no rotation is known. */
  turns: number;
  /** Directions of mirror lines, in degrees from 0 to 180, in order. */
  mirrors: number[];
}

const ORDERS = [12, 10, 9, 8, 7, 6, 5, 4, 3, 2];
/** A mirror is looked for in every direction of these steps, in degrees. */
const STEPS = [7.5, 18, 180 / 7];
/** How far numbers may be off, in proportion. */
const NEAR = 1e-9;

export function symmetriesOf(maps: readonly MapRow[]): Symmetries {
  // One map has a point for a shape, and a flat one more symmetries than it shows.
  const centre = middleOf(maps);
  if (maps.length < 2 || centre === null) return { turns: 1, mirrors: [] };
  const about = ([a, b, c, d]: [number, number, number, number]): MapRow => [
    a,
    b,
    c,
    d,
    centre[0] - a * centre[0] - b * centre[1],
    centre[1] - c * centre[0] - d * centre[1],
  ];
  const turned = (angle: number) =>
    about([Math.cos(angle), -Math.sin(angle), Math.sin(angle), Math.cos(angle)]);
  const mirrored = (angle: number) =>
    about([Math.cos(2 * angle), Math.sin(2 * angle), Math.sin(2 * angle), -Math.cos(2 * angle)]);
  const turns = ORDERS.find((order) => keeps(maps, turned((2 * Math.PI) / order))) ?? 1;
  const angles = new Set(
    STEPS.flatMap((step) => Array.from({ length: Math.round(180 / step) }, (_, i) => i * step)),
  );
  const mirrors = [...angles].filter((angle) => keeps(maps, mirrored((angle * Math.PI) / 180)));
  return { turns, mirrors: mirrors.sort((p, q) => p - q) };
}

/** The mean of the points that the maps leave where they are: every such symmetry leaves it, too. */
function middleOf(maps: readonly MapRow[]): [number, number] | null {
  let [x, y] = [0, 0];
  for (const [a, b, c, d, e, f] of maps) {
    const det = (1 - a) * (1 - d) - b * c;
    x += ((1 - d) * e + b * f) / det / maps.length;
    y += (c * e + (1 - a) * f) / det / maps.length;
  }
  return Number.isFinite(x) && Number.isFinite(y) ? [x, y] : null;
}

/** Whether a symmetry of the plane makes each map one of them again. */
function keeps(maps: readonly MapRow[], g: MapRow): boolean {
  const [a, b, c, d, e, f] = g;
  // Its inverse: that of a rotation or mirroring is its transpose.
  const back: MapRow = [a, c, b, d, -(a * e + c * f), -(b * e + d * f)];
  const size = Math.max(1, ...maps.flat().map(Math.abs));
  const left = new Set(maps);
  return maps.every((map) => {
    const image = after2(g, after2(map, back));
    for (const other of left) {
      if (other.every((x, k) => Math.abs(x - (image[k] ?? 0)) <= NEAR * size)) return left.delete(other);
    }
    return false;
  });
}
