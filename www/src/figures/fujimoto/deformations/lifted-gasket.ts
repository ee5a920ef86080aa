/** The gasket of Figure 4, lifted in the middle of its long side. */

import type { Box } from "#document/framing";
import type { Deformation, MapRow } from "#wasm/api";
import { rightGasket } from "../codes/addresses";
import { deformationBy } from "./deformations";
import { LIFT } from "./meshes";

export const GASKET: MapRow[] = rightGasket(0.5);
export const LIFT_BOX: Box = { x0: 0, y0: 0, x1: 1, y1: 1 };
/** The piece 1111, which is far from the pull. */
export const FAR_CORNER: Box = { x0: 0, y0: 0, x1: 0.068, y1: 0.068 };
/** Detail: so many letters of a code take part. */
export const KE = 9;

export function liftOf(settings: Partial<Deformation>): Deformation {
  return deformationBy(LIFT, { ke: KE, ...settings });
}
