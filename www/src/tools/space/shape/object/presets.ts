import type { Preset3 } from "#wasm/api";
import { solid } from "#wasm/space";

let all: Preset3[] | null = null;

/** The gallery of space: asked for once. */
export function presets(): Preset3[] {
  all ??= solid.presets3();
  return all;
}
