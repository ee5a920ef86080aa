import { dark } from "#document/preferences";
import { palette } from "#style/palette";
import shapeCss from "../shape.module.css";

/** The number of a map or an object in its colour. */
export function Swatch({ map, tint }: { map: number; tint?: string | undefined }) {
  const colours = palette(dark.value ? "dark" : "light");
  return (
    <span
      class={shapeCss["solid-swatch"]}
      aria-hidden="true"
      style={{ background: tint ?? colours[map % colours.length] ?? "gray" }}
    />
  );
}
