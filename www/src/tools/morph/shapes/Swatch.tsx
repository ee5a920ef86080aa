import { pieceColours } from "#document/colours";
import { dark } from "#document/preferences";
import morphCss from "../morph.module.css";

/**
 * The number of a map (from 0 here, from 1 on screen), which needs no colour, in the colour that its pieces have on the
 * stage: that of its own place, or of the place that it has in a morph.
 */
export function Swatch({ map, colour = map }: { map: number; colour?: number | undefined }) {
  const colours = pieceColours(dark.value ? "dark" : "light");
  return (
    <span
      class={morphCss["swatch"]}
      style={{ "--swatch": colours[colour % colours.length] ?? "currentColor" }}
    >
      {map + 1}
    </span>
  );
}
