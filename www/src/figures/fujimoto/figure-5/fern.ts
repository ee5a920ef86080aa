/** Barnsley's fern as the paper sways it. */
import type { Deformation, MapRow, Spin } from "#wasm/api";
import { deformationBy, toAndFro } from "../deformations/deformations";
import { SWAY } from "../deformations/meshes";

/** The paper's maps in the paper's order. */
export const FERN: MapRow[] = [
  [0.85, 0.04, -0.04, 0.85, 0, 1.6],
  [0.2, -0.26, 0.23, 0.22, 0, 1.6],
  [-0.15, 0.28, 0.26, 0.24, 0, 0.44],
  [0, 0, 0, 0.16, 0, 0],
];
/** Detail: so many letters of a code take part. */
export const KE = 6;
export const SPIN: Spin = "rotation";

export function swayOf(settings: Partial<Deformation>): Deformation {
  return deformationBy(SWAY, {
    ke: KE,
    spin: SPIN,
    keys: toAndFro(SWAY),
    loop: true,
    seconds: 6,
    ...settings,
  });
}
