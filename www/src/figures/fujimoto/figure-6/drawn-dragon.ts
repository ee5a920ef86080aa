/** The twin-dragon as the paper draws it at one corner, with colours of its own. */
import type { Deformation, MapRow } from "#wasm/api";
import { deformationBy } from "../deformations/deformations";
import { DRAGON_COLOURS, DRAW } from "../deformations/meshes";

/** The paper's maps in the paper's order. */
export const TWIN: MapRow[] = [
  [0.5, 0.5, -0.5, 0.5, -0.5, 0.375],
  [0.5, 0.5, -0.5, 0.5, 0.5, 0.625],
];
/** Detail: so many letters of a code take part. */
export const KE = 8;

const TINT = { colours: [...DRAGON_COLOURS], kb: 0, ke: KE, delta: 1, superposed: true };
/** The colours before they are shuffled. */
export const PLAIN_TINT = { kb: KE, tint: { ...TINT, ke: 0 } };

export function drawnOf(settings: Partial<Deformation>): Deformation {
  return deformationBy(DRAW, { ke: KE, delta: 1, spin: "scaled", tint: TINT, ...settings });
}
