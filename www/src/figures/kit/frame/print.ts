/** Paper is light: pictures that a script has drawn for a dark page are drawn anew before the page is printed. */
import { options } from "preact";
import { dark, setTheme, type Theme, theme } from "#document/preferences";
import { lighten } from "../picture/recolour";

/** From now on, until what it gives is called. */
export function printLight(): () => void {
  addEventListener("beforeprint", beLight);
  addEventListener("afterprint", beAsBefore);
  return () => {
    beAsBefore();
    removeEventListener("beforeprint", beLight);
    removeEventListener("afterprint", beAsBefore);
  };
}

/** The theme to go back to. */
let before: Theme | null = null;

/** At once; a picture that a worker draws is recoloured until it follows a moment later. */
export function beLight(): void {
  if (!dark.peek() || before !== null) return;
  before = theme.peek();
  for (const canvas of document.querySelectorAll<HTMLCanvasElement>("canvas[data-flat]")) lighten(canvas);
  atOnce(() => setTheme("light", { keep: false }));
}

export function beAsBefore(): void {
  const theme = before;
  before = null;
  if (theme !== null) atOnce(() => setTheme(theme, { keep: false }));
}

/** The browser takes the page as it stands when the listener returns: nothing may wait for its turn. */
export function atOnce(change: () => void): void {
  const { debounceRendering } = options;
  options.debounceRendering = (render) => render();
  try {
    change();
  } finally {
    if (debounceRendering) options.debounceRendering = debounceRendering;
    else delete options.debounceRendering;
  }
}
