/** Numbers that the maps of a shape mean exactly: formulas, in the words of a link. */
import type { MapRow, Shape } from "#wasm/api";

/** A link holds no more of a shape. */
const MOST_FORMULAS = 64;

/** Formulas of shapes of the gallery, joined by commas: what the first picture needs does not wait for them. */
export const GALLERY = new Map<string, string>();

/** Formulas as doubles, as far as the module for exact numbers has read them. */
export const doubles = new Map<string, number>();

/** The formulas that hold for a shape. One of the gallery says none itself. */
export const exactOf = ({ preset = "", exact }: Shape): readonly string[] =>
  exact ?? GALLERY.get(preset)?.split(",") ?? [];

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
  const entries = new Set(maps.flat().map(Math.abs));
  const all = [...new Set([...more, ...exactOf(before)])].filter((formula) => {
    const double = doubles.get(formula);
    // The latest that has a double is the one that it means.
    return double === undefined || entries.delete(Math.abs(double));
  });
  return withExact({ name, maps }, all.slice(0, MOST_FORMULAS));
}
