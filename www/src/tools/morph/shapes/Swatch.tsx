import { pieceColours } from "#document/colours";
import { dark } from "#document/preferences";
import morphCss from "../morph.module.css";

/** The colour of a map and its number (from 0 here, from 1 on screen) in it: the number is what needs no colour. */
export function Swatch({ map }: { map: number }) {
  const colours = pieceColours(dark.value ? "dark" : "light");
  return (
    <span class={morphCss["swatch"]} style={{ "--swatch": colours[map % colours.length] ?? "currentColor" }}>
      {map + 1}
    </span>
  );
}
