/** How graph-directed shapes are drawn. */
import type { Colouring, DirectedRasterOptions } from "#wasm/api";

/** Maps that lead to the state that a colour tells. */
const LEVEL = 3;

/** What colours tell: the map, the state, or nothing. */
export function directedLook(
  colouring: Colouring,
  palette: readonly string[],
): Pick<DirectedRasterOptions, "level" | "palette"> {
  if (colouring === "address") return { level: LEVEL, palette: [...palette] };
  return { level: 0, palette: colouring === "map" ? [...palette] : palette.slice(0, 1) };
}
