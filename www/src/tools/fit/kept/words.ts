import type { KeptFit } from "#document/kept/fits";
import { percent } from "#format/nearness";
import type { Fit } from "#wasm/api";
import * as messages from "../messages";
import { numbersOf } from "../work/outline";

/** How near a fit is and what it takes. */
export function aboutWords({ rms, bytes }: Pick<KeptFit, "rms" | "bytes">, { curve }: Fit): string {
  const parts = [
    ...(curve ? [messages.numbers(numbersOf(curve.curve))] : []),
    messages.bytes(bytes.toLocaleString("en-GB")),
  ];
  return (rms === null ? parts : [messages.error(percent(rms)), ...parts]).join(" · ");
}
