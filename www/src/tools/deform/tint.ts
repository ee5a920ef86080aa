/** Colours of the control points. */

import { FOUR, GREY } from "#style/colours";
import { channelsOf, hexOf } from "#style/hex";
import type { Colouring, Deformation, Scene, Tint } from "#wasm/api";

/** Lower left, lower right, upper left, upper right. */
export type Four = readonly [string, string, string, string];

/** At the corners of a grid, to begin with. */
export const FIRST: Four = FOUR;

type Sides = Pick<Deformation, "columns" | "rows">;

/** The four corners, blended over the control points. */
export function blended(four: Four, { columns, rows }: Sides): string[] {
  const corners = four.map(channelsOf);
  return Array.from({ length: columns * rows }, (_, i) => {
    const u = (i % columns) / (columns - 1);
    const v = Math.floor(i / columns) / (rows - 1);
    const weights = [(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v];
    return hexOf([0, 1, 2].map((k) => weights.reduce((sum, w, j) => sum + w * (corners[j]?.[k] ?? 0), 0)));
  });
}

/** The colours at the corners of the mesh. */
export function cornersOf(colours: readonly string[], { columns, rows }: Sides): Four {
  const at = (i: number) => colours[i] ?? GREY;
  return [at(0), at(columns - 1), at((rows - 1) * columns), at(rows * columns - 1)];
}

/** Whether every colour is what its corners blend to. */
export function isBlended(colours: readonly string[], sides: Sides): boolean {
  const plain = blended(cornersOf(colours, sides), sides);
  return plain.every((colour, i) => colour === colours[i]);
}

/** One corner in another colour: a blend follows, colours chosen one by one stay. */
export function withCorner(
  colours: readonly string[],
  sides: Sides,
  corner: number,
  colour: string,
): string[] {
  const four = cornersOf(colours, sides).map((c, i) => (i === corner ? colour : c)) as unknown as Four;
  if (isBlended(colours, sides)) return blended(four, sides);
  const { columns, rows } = sides;
  const index = [0, columns - 1, (rows - 1) * columns, rows * columns - 1][corner] ?? 0;
  return colours.map((c, i) => (i === index ? colour : c));
}

/** What a colouring by the grid begins with: less deep and less rough than the bend, so that colours stay apart. */
export function firstTint(deformation: Deformation): Tint {
  const { kb, ke, superposed } = deformation;
  const most = Math.min(ke, 6);
  return {
    colours: blended(FIRST, deformation),
    kb: Math.min(kb, most),
    ke: most,
    delta: 0.5,
    superposed,
  };
}

/** Coloured by something else; by the grid, it gets colours if it has none yet. */
export function withColouring(scene: Scene, colouring: Colouring, deformation: Deformation): Scene {
  if (scene.colouring === colouring && (colouring !== "grid" || scene.deform?.tint)) return scene;
  if (colouring !== "grid" || scene.deform?.tint) return { ...scene, colouring };
  return { ...scene, colouring, deform: { ...deformation, tint: firstTint(deformation) } };
}
