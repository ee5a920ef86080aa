/** Paper is light: pictures that a script has drawn for a dark page are drawn anew before the page is printed. */
import { options } from "preact";
import { dark, setTheme, type Theme, theme } from "#document/preferences";

/** From now on, until what it gives is called. */
export function printLight(): () => void {
  let before: Theme | null = null;
  const begin = () => {
    if (!dark.peek() || before !== null) return;
    before = theme.peek();
    atOnce(() => setTheme("light", { keep: false }));
  };
  const end = () => {
    const theme = before;
    before = null;
    if (theme !== null) atOnce(() => setTheme(theme, { keep: false }));
  };
  addEventListener("beforeprint", begin);
  addEventListener("afterprint", end);
  return () => {
    end();
    removeEventListener("beforeprint", begin);
    removeEventListener("afterprint", end);
  };
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
