/** What is typed into the fields of a map, as exact numbers. */
import { type ExactNumber, readExact } from "#document/editing/exact";
import { compose, type Parts } from "#geometry/maps/affine2";

export interface LinearPart {
  linear: [a: number, b: number, c: number, d: number];
  /** Formulas of those of its entries that are no doubles. */
  exact: string[];
}

const formulas = () => import("#format/formula");

/** By so much, as a part of its size, what a formula is worth may differ from what the field has read. */
const SAME = 1e-12;
const near = (p: number, q: number) => Math.abs(p - q) <= SAME * Math.max(1, Math.abs(p));

/** The number that was typed for an entry, if it is one of the fields that Frond computes in. */
export async function exactEntry(text: string, value: number): Promise<ExactNumber | null> {
  const { formulaOf } = await formulas();
  const [found] = await read([formulaOf(text)]);
  return found && near(found.value, value) && !isDyadic(found.formula) ? found : null;
}

/** A formula of a document as people write it. */
export const shownExact = (formula: string | undefined): string | undefined =>
  formula
    ?.replace(/sqrt\((\d+)\)/g, "√$1")
    .replace(/sqrt/g, "√")
    .replace(/(\d)deg/g, "$1°")
    .replace(/\*\*/g, "^")
    .replace(/-/g, "−");

const PARTS = ["turn", "stretchX", "stretchY", "slant"] as const;
const UNITS: Partial<Record<keyof Parts, string>> = { turn: "°", stretchX: "×", stretchY: "×" };

/**
 * The linear part of a map whose turn, stretch and slant were typed, some as formulas; null where none was, or one is
 * neither a formula nor a short decimal. `typed` has the texts of formulas.
 */
export function exactParts(
  parts: Parts,
  typed: (key: keyof Parts) => string | undefined,
): Promise<LinearPart | null> | null {
  return PARTS.some((key) => typed(key) !== undefined) ? composed(parts, typed) : null;
}

async function composed(
  parts: Parts,
  typed: (key: keyof Parts) => string | undefined,
): Promise<LinearPart | null> {
  const { formulaOf } = await formulas();
  const texts: string[] = [];
  for (const key of PARTS) {
    const words = typed(key);
    const text = words === undefined ? decimalOf(parts[key]) : formulaOf(words, UNITS[key]);
    if (text === null) return null;
    texts.push(`(${text})`);
  }
  const [turn, x, y, slant] = texts;
  const [cos, sin] = [`cos(${turn}deg)`, `sin(${turn}deg)`];
  const found = await read([
    `${x}*${cos}`,
    `${slant}*${cos}-${y}*${sin}`,
    `${x}*${sin}`,
    `${slant}*${sin}+${y}*${cos}`,
  ]);
  const plain = compose(parts);
  const linear = found.map((one, k) => (one && near(one.value, plain[k] ?? Number.NaN) ? one.value : null));
  if (linear.includes(null)) return null;
  const exact = found.flatMap((one) => one?.formula ?? []).filter((formula) => !isDyadic(formula));
  return { linear: linear as LinearPart["linear"], exact };
}

/** A short decimal that says all of a number. */
function decimalOf(x: number): string | null {
  const short = String(Number(x.toPrecision(LONGEST)));
  return short.length <= LONGEST && near(Number(short), x) ? short : null;
}

const LONGEST = 8;

/** Fractions that are doubles themselves need no formula. */
function isDyadic(formula: string): boolean {
  const [, under] = /^-?\d{1,15}(?:\/(\d{1,9}))?$/.exec(formula) ?? [];
  return under === undefined ? /^-?\d+$/.test(formula) : Number.isInteger(Math.log2(Number(under)));
}

/** Without the module, or beyond its fields, a formula is the double that it is worth. */
async function read(list: string[]): Promise<(ExactNumber | null)[]> {
  try {
    return await readExact(list);
  } catch {
    return list.map(() => null);
  }
}
