import type { Preset, Shape } from "#wasm/api";
import { frond } from "#wasm/core";

let loaded: readonly Preset[] | null = null;

/** The gallery, in its order. */
export function presets(): readonly Preset[] {
  loaded ??= frond.presets();
  return loaded;
}

/** The preset that a shape was made from: by its id, or, once its maps were edited, by the name it kept. */
export function originOf(shape: Shape): Preset | undefined {
  return presets().find((preset) => preset.id === shape.preset || preset.name === shape.name);
}
