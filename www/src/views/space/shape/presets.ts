import type { Preset3 } from "#engine/api";
import { solid } from "#engine/space/module";

let all: Preset3[] | null = null;

/** The gallery of space: asked for once. */
export function presets(): Preset3[] {
  all ??= solid.presets3();
  return all;
}
