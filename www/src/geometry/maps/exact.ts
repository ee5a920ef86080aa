/** Numbers that the maps of a shape mean exactly: formulas, in the words of a link. */
import type { MapRow, Shape } from "#wasm/api";

/** A link holds no more of a shape. */
export const MOST_FORMULAS = 64;

const hexagon = "1/3,2/3,sqrt(3)/3";
const board = "1/3,2/3";
const terdragon = "sqrt(3)/6,sqrt(3)/3";
/** Of shapes of the gallery. Entries of the others are what their digits say. */
const GALLERY: Readonly<Record<string, string>> = {
  gasket: "sqrt(3)/4",
  terdragon,
  "terdragon-mirrored": terdragon,
  koch: "1/3,2/3,1/6,sqrt(3)/6",
  carpet: board,
  vicsek: board,
  pentagon: "(3-sqrt(5))/2,(sqrt(5)-1)/2,(3-sqrt(5))/4,sin(36deg),tan(36deg)/2",
  hexagon,
  hexaflake: hexagon,
  gosper: "5/14,2/7,1/14,sqrt(3)/14,sqrt(3)/7,3sqrt(3)/14",
};

/** The sizes of formulas as doubles, as far as the module for exact numbers has read them. */
export const sizes = new Map<string, number>();

/** The formulas that hold for a shape. One of the gallery says none itself. */
export const exactOf = ({ preset = "", exact }: Shape): readonly string[] =>
  exact ?? GALLERY[preset]?.split(",") ?? [];

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
    const size = sizes.get(formula);
    return size === undefined || entries.has(size);
  });
  return withExact({ name, maps }, all.slice(0, MOST_FORMULAS));
}
