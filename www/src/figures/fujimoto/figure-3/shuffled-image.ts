/** Figure 3: colours of a square, and of the gasket in it, rearranged by a shuffle. */
import { type Rgb, shade, thirds } from "../deformations/meshes";

/** Letters of the smallest cells, which are the pixels of an image. */
export const LETTERS = 7;
const SIDE = 2 ** LETTERS;

/** What is coloured: the whole square of four letters, or the gasket of three in it, which lacks the fourth. */
export type Subject = "square" | "gasket";

interface ShuffledImage {
  side: number;
  /** RGBA, row 0 on top. */
  pixels: Uint8ClampedArray<ArrayBuffer>;
}

/**
 * One coordinate of the cell that a shuffle takes a cell to. The letter of a cell is ix + 2 iy, so a code is reversed
 * where the binary digits of both coordinates are.
 */
export function digitsReversed(x: number, kb: number, ke: number): number {
  let out = x;
  for (let place = kb; place < ke; place++) {
    const from = LETTERS - 1 - place;
    const to = LETTERS - 1 - (kb + ke - 1 - place);
    out = (out & ~(1 << to)) | (((x >> from) & 1) << to);
  }
  return out;
}

/**
 * F_e-uni,c (eq 11): the colours of the square after the shuffle kb to ke. Superposed: the mean of all kb to ke (eq
 * 12).
 */
export function shuffledImage(subject: Subject, kb: number, ke: number, superposed: boolean): ShuffledImage {
  const tables = tablesOf(kb, ke, superposed);
  const pixels = new Uint8ClampedArray(4 * SIDE * SIDE);
  for (let y = 0; y < SIDE; y++) {
    for (let x = 0; x < SIDE; x++) {
      // A cell of the gasket has no letter with both digits 1.
      if (subject === "gasket" && (x & y) !== 0) continue;
      const at = 4 * ((SIDE - 1 - y) * SIDE + x);
      pixels.set([...shade(colourAt(tables, x, y)), 255], at);
    }
  }
  return { side: SIDE, pixels };
}

/** For each term where each coordinate comes from. */
function tablesOf(kb: number, ke: number, superposed: boolean): number[][] {
  const depths = superposed ? Array.from({ length: ke - kb + 1 }, (_, i) => kb + i) : [ke];
  return depths.map((depth) =>
    Array.from({ length: SIDE }, (_, x) => (digitsReversed(x, kb, depth) + 0.5) / SIDE),
  );
}

/** How much red, green and blue three quarters of the square have on average. */
export function meanParts(kb: number, ke: number, superposed: boolean) {
  const tables = tablesOf(kb, ke, superposed);
  const half = SIDE / 2;
  const mean = (x0: number, y0: number): Rgb => {
    const sum = [0, 0, 0];
    for (let y = y0; y < y0 + half; y++) {
      for (let x = x0; x < x0 + half; x++) {
        for (const [i, part] of colourAt(tables, x, y).entries()) sum[i] = (sum[i] ?? 0) + part / half ** 2;
      }
    }
    return sum as unknown as Rgb;
  };
  return { lowerLeft: mean(0, 0), lowerRight: mean(half, 0), upperLeft: mean(0, half) };
}

function colourAt(tables: readonly (readonly number[])[], x: number, y: number): Rgb {
  const sum = [0, 0, 0];
  for (const table of tables) {
    const parts = thirds(table[x] ?? 0, table[y] ?? 0);
    for (let i = 0; i < 3; i++) sum[i] = (sum[i] ?? 0) + (parts[i] ?? 0) / tables.length;
  }
  return sum as unknown as Rgb;
}
