/** Numbers that the maps of a shape mean exactly: formulas beside the doubles that are nearest to them. */
import type { MapRow, Shape } from "#wasm/api";

/** A link holds no more of a shape. */
export const MOST_FORMULAS = 64;
/** Whether a link can hold it: `crate/scene/src/link/words.rs` reads it. */
export const isFormula = (text: unknown): text is string =>
  typeof text === "string" && /^[a-z0-9./()*+^-]{1,200}$/.test(text);

/** Of the gallery: the formulas of all its shapes, each with its double. The entries of all other maps are dyadic. */
const GALLERY: readonly (readonly [number, string])[] = [
  [0.3333333333333333, "1/3"],
  [0.6666666666666666, "2/3"],
  [0.16666666666666666, "1/6"],
  [0.4330127018922193, "sqrt(3)/4"],
  [0.28867513459481287, "sqrt(3)/6"],
  [0.5773502691896257, "sqrt(3)/3"],
  [0.38196601125010515, "(3-sqrt(5))/2"],
  [0.6180339887498949, "(sqrt(5)-1)/2"],
  [0.19098300562505258, "(3-sqrt(5))/4"],
  [0.5877852522924731, "sin(36deg)"],
  [0.36327126400268045, "tan(36deg)/2"],
  [0.35714285714285715, "5/14"],
  [0.2857142857142857, "2/7"],
  [0.07142857142857142, "1/14"],
  [0.12371791482634838, "sqrt(3)/14"],
  [0.24743582965269675, "sqrt(3)/7"],
  [0.37115374447904514, "3sqrt(3)/14"],
];

/** The doubles of formulas, as far as the module for exact numbers has read them. */
const doubles = new Map<string, number>(GALLERY.map(([value, formula]) => [formula, value]));

export const doubleOf = (formula: string): number | undefined => doubles.get(formula);

export function learn(formula: string, double: number): void {
  doubles.set(formula, Math.abs(double));
}

/** Those formulas that stand for an entry, or of which that is not known yet. */
function used(formulas: readonly string[], maps: readonly MapRow[]): readonly string[] {
  const entries = new Set(maps.flat().map(Math.abs));
  return formulas.filter(
    (formula) => entries.has(doubles.get(formula) ?? Number.NaN) || !doubles.has(formula),
  );
}

/** The formulas that hold for a shape. One of the gallery says none itself. */
export function exactOf({ preset, maps, exact }: Shape): readonly string[] {
  if (preset === undefined) return exact ?? [];
  return used(
    GALLERY.map(([, formula]) => formula),
    maps,
  );
}

/** The formula among these that an entry of a map stands for; of its opposite with a minus. */
export function formulaAt(x: number, formulas: readonly string[]): string | undefined {
  const formula = formulas.find((one) => doubles.get(one) === Math.abs(x));
  if (formula === undefined || x >= 0) return formula;
  const isTerm = !/[+-]/.test(formula) || /^\(.*\)\/\d+$/.test(formula);
  return isTerm ? `-${formula}` : `-(${formula})`;
}

/** A shape with these formulas, or without any. */
export function withExact(shape: Shape, exact: readonly string[] | undefined): Shape {
  const { exact: _, ...rest } = shape;
  return exact?.length ? { ...rest, exact: [...exact] } : rest;
}

/**
 * Other maps of the same shape, whose numbers mean what they meant wherever they are still the same, and some perhaps
 * what these formulas say.
 */
export function carriedExact(
  before: Shape,
  name: string,
  maps: MapRow[],
  more: readonly string[] = [],
): Shape {
  const all = used([...new Set([...more, ...exactOf(before)])], maps);
  return withExact({ name, maps }, all.slice(0, MOST_FORMULAS));
}
