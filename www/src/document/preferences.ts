/** What belongs to whoever looks and not to the document: light or dark, and whether anything may move by itself. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { media } from "#style/media";

export type Theme = "auto" | "light" | "dark";
const KEY = "frond.theme";

/** `?theme=dark`: as somebody shared it, for this visit. `index.html` reads the same before anything is drawn. */
export function themeIn(search: string): "light" | "dark" | null {
  const asked = new URLSearchParams(search).get("theme");
  return asked === "light" || asked === "dark" ? asked : null;
}

/** Storage may be missing, full or forbidden: then the choice lasts as long as the page. */
function read(): Theme {
  const asked = themeIn(globalThis.location?.search ?? "");
  if (asked) return asked;
  try {
    const kept = localStorage.getItem(KEY);
    return kept === "light" || kept === "dark" ? kept : "auto";
  } catch {
    return "auto";
  }
}

const chosen = signal<Theme>(read());
const systemDark = media("(prefers-color-scheme: dark)");

export const theme: ReadonlySignal<Theme> = chosen;
/** What the choice comes to now. */
export const dark: ReadonlySignal<boolean> = computed(() =>
  chosen.value === "auto" ? systemDark.value : chosen.value === "dark",
);
/** Nothing moves by itself, and nothing eases. */
export const reducedMotion: ReadonlySignal<boolean> = media("(prefers-reduced-motion: reduce)");

/** Without `keep` it holds for this visit only. */
export function setTheme(next: Theme, { keep = true }: { keep?: boolean } = {}): void {
  // First, as what is drawn anew by the signal reads colours of the page.
  if (next === "auto") delete document.documentElement.dataset["theme"];
  else document.documentElement.dataset["theme"] = next;
  chosen.value = next;
  if (!keep) return;
  try {
    if (next === "auto") localStorage.removeItem(KEY);
    else localStorage.setItem(KEY, next);
  } catch {
    // Kept for this visit only.
  }
}
