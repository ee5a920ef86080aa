/**
 * Displacements and colours at the control points of the figures on fractal deformation. The paper says that there are
 * 4 x 4 of them, blended by Bezier interpolation of degree 3, and what they do; it prints no numbers. All of these are
 * reconstructed from those words.
 */
import { hexOf } from "#style/hex";
import type { Bend } from "#wasm/api";

export interface NamedMesh {
  name: string;
  /** What the paper says of it. */
  about: string;
  box: Bend["box"];
  /** dx, dy of each control point, row by row from the lower left, at its fullest. */
  moves: readonly number[];
}

const SIDE = 4;

/** Rows from the lowest on, each from left to right. */
function mesh(
  name: string,
  about: string,
  box: Bend["box"],
  move: (i: number, j: number) => [number, number],
) {
  const moves = Array.from({ length: SIDE * SIDE }, (_, n) => move(n % SIDE, Math.floor(n / SIDE))).flat();
  return { name, about, box, moves: moves.map((x) => Math.round(x * 1e4) / 1e4 + 0) };
}

/** Figure 4: the midpoint of the hypotenuse is lifted, the rim stays. */
const RISE = [
  [0, 0, 0, 0],
  [0, 0.168, 0.28, 0],
  [0, 0.28, 0.364, 0],
  [0, 0, 0, 0],
];
export const LIFT: NamedMesh = mesh(
  "Lift",
  "the midpoint of the hypotenuse is lifted",
  [0, 0, 1, 1],
  (i, j) => {
    const rise = RISE[j]?.[i] ?? 0;
    return [rise, rise];
  },
);

/** Figure 5: the upper part of the fern goes to a side, the foot stays. */
const LEAN = [0, 0, 0.77, 2.2];
export const SWAY: NamedMesh = mesh(
  "Sway",
  "the upper part of the fern sways from side to side",
  [-3, 0, 3, 10.2],
  (_, j) => [LEAN[j] ?? 0, -0.25 * (LEAN[j] ?? 0)],
);

/** Figure 6: the lower right part goes to the lower right, the upper left stays. */
export const DRAW: NamedMesh = mesh(
  "Draw",
  "the lower right part is drawn to the lower right",
  [-1, -0.7, 2, 1.7],
  (i, j) => {
    const pull = 0.85 * ((i / 3) * (1 - j / 3)) ** 1.2;
    return [pull, -0.8 * pull];
  },
);

/** The mesh part of the way, or the other way where `part` is negative. */
export function movesOf({ moves }: NamedMesh, part: number): number[] {
  return moves.map((x) => x * part + 0);
}

export type Rgb = readonly [red: number, green: number, blue: number];

/**
 * Figure 3: the colour of a point of the unit square, as parts of red, green and blue. Upper left is red, lower right
 * blue, lower left and upper right green; the parts sum to 1 everywhere.
 */
export function thirds(x: number, y: number): Rgb {
  return [(1 - x) * y, x * y + (1 - x) * (1 - y), x * (1 - y)];
}

/** Parts as a colour on screen, 0 to 255: evenly bright, whatever the mixture, and none of them glaring. */
export function shade(parts: Rgb): Rgb {
  const most = Math.max(...parts, 1e-9);
  // Half-way between the plain parts, which are dull where they are mixed, and the brightest of that hue.
  const bright = parts.map((part) => Math.sqrt((0.35 * part + 0.65 * (part / most)) * part));
  return bright.map((part, i) => Math.round(28 + part * (STRENGTH[i] ?? 0))) as unknown as Rgb;
}

/** The same without the brightening, which a blend of control points knows nothing of: "#rrggbb". */
export function plainShade(parts: Rgb): string {
  return hexOf(parts.map((part, i) => 28 + part * (STRENGTH[i] ?? 0)));
}

/** Of red, green and blue: green looks brightest. */
const STRENGTH: Rgb = [208, 152, 214];

/** Figure 6, (Y): four colours at the corners of the mesh, blended. */
const CORNER_COLOURS: readonly Rgb[] = [
  [0.84, 0.08, 0.36],
  [0.04, 0.24, 0.95],
  [1.0, 0.68, 0.0],
  [0.0, 0.66, 0.27],
];

/** "#rrggbb" of each control point, row by row from the lower left. */
export const DRAGON_COLOURS: readonly string[] = Array.from({ length: SIDE * SIDE }, (_, n) => {
  const [x, y] = [(n % SIDE) / (SIDE - 1), Math.floor(n / SIDE) / (SIDE - 1)];
  const weights = [(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y];
  const parts = [0, 1, 2].map((part) =>
    weights.reduce((sum, weight, corner) => sum + weight * (CORNER_COLOURS[corner]?.[part] ?? 0), 0),
  );
  return hexOf(parts.map((part) => 255 * part));
});
