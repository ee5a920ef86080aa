import type { KeptFit } from "#document/kept/fits";
import { percent } from "#format/nearness";
import type { Fit } from "#wasm/api";
import { numbersOf } from "../work/outline";

/** How near a fit is and what it takes. */
export function aboutWords({ rms, bytes }: Pick<KeptFit, "rms" | "bytes">, { curve }: Fit): string {
  const parts = [
    ...(curve ? [`${numbersOf(curve.curve)} numbers`] : []),
    `${bytes.toLocaleString("en-GB")} bytes`,
  ];
  return (rms === null ? parts : [`${percent(rms)} off`, ...parts]).join(" · ");
}
