/**
 * Codes of the points of unit cubes, and what a shuffle does to a code. Letters count from 0 here, from 1 on screen.
 */

/** Cut into `parts` along each side; the letter of a cell is ix + parts * iy (Fujimoto et al., Fig 1). */
export interface Cube {
  dimensions: 1 | 2;
  parts: number;
}

/** How many letters there are: the paper's L. */
export function lettersOf({ dimensions, parts }: Cube): number {
  return parts ** dimensions;
}

/** The first letters of a point's code. Cells hold their lower sides, the last ones also the upper. */
export function codeOf({ dimensions, parts }: Cube, point: readonly number[], count: number): number[] {
  let left = Array.from({ length: dimensions }, (_, axis) => Math.min(1, Math.max(0, point[axis] ?? 0)));
  return Array.from({ length: count }, () => {
    const digits = left.map((x) => Math.min(parts - 1, Math.floor(x * parts)));
    left = left.map((x, axis) => x * parts - (digits[axis] ?? 0));
    return digits.reduceRight((letter, digit) => letter * parts + digit, 0);
  });
}

/** The cell of a code: its lower corner, and how long its sides are. */
export function cellOf(
  { dimensions, parts }: Cube,
  code: readonly number[],
): { corner: number[]; side: number } {
  const corner = new Array<number>(dimensions).fill(0);
  let side = 1;
  for (const letter of code) {
    side /= parts;
    for (let axis = 0, left = letter; axis < dimensions; axis++, left = Math.floor(left / parts)) {
      corner[axis] = (corner[axis] ?? 0) + (left % parts) * side;
    }
  }
  return { corner, side };
}

/** D_e-uni: the letters kb + 1 to ke in reverse, the others as they are (Fujimoto et al., eq 4). */
export function shuffled(code: readonly number[], kb: number, ke: number): number[] {
  return [...code.slice(0, kb), ...code.slice(kb, ke).reverse(), ...code.slice(Math.max(kb, ke))];
}

/** All codes of so many letters, in the order of a dictionary. */
export function allCodes(letters: number, count: number): number[][] {
  let codes: number[][] = [[]];
  for (let i = 0; i < count; i++) {
    codes = codes.flatMap((code) => Array.from({ length: letters }, (_, letter) => [...code, letter]));
  }
  return codes;
}

/** A code as it is shown: letters from 1, apart where one of them has two digits. */
export function codeWords(code: readonly number[]): string {
  return code.map((letter) => letter + 1).join(code.some((letter) => letter > 8) ? " " : "");
}
