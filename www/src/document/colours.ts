/** The colours of a shape's pieces. */
import { palette } from "#style/palette";
import type { Scene } from "#wasm/api";
import { scene } from "./scene";

/** One a map, repeated where there are more: the document's own, which a file may have brought, else the page's. */
export function pieceColours(theme: "light" | "dark"): string[] {
  return ownColours(scene.value) ?? palette(theme);
}

/** The colours of maps that have other places in a morph; the very same list where none has. */
export function ranked(colours: string[], ranks: readonly number[]): string[] {
  if (ranks.every((rank, i) => rank === i)) return colours;
  return ranks.map((rank) => colours[rank % colours.length] ?? "");
}

/** Those of the document; null where it has none. Closed curves have arcs in place of maps. */
export function ownColours({ palette: own, curves }: Scene): string[] | null {
  return own && own.length > 0 && !curves ? own : null;
}

/** The document with the page's colours. */
export function withoutColours({ palette: _, ...rest }: Scene): Scene {
  return rest;
}
