/**
 * Okabe-Ito, one colour a map, in an order in which neighbours differ most. On light paper the same hues are darker, so
 * that each keeps a contrast of at least 3 to 1 with its ground.
 */
const DARK = ["#e69f00", "#56b4e9", "#009e73", "#f0e442", "#4d8fd6", "#d55e00", "#cc79a7", "#c9ccd3"];
const LIGHT = ["#c47800", "#0072b2", "#00835f", "#8f8500", "#2b7fb8", "#c04f00", "#a8558a", "#4a4f5a"];

export function palette(theme: "light" | "dark"): string[] {
  return theme === "dark" ? DARK : LIGHT;
}
