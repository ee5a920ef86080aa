import { computed, type ReadonlySignal, signal } from "@preact/signals";

export type Theme = "auto" | "light" | "dark";
const KEY = "frond.theme";

/** Storage may be missing, full or forbidden: then the choice lasts as long as the page. */
function read(): Theme {
  try {
    const kept = localStorage.getItem(KEY);
    return kept === "light" || kept === "dark" ? kept : "auto";
  } catch {
    return "auto";
  }
}

function watch(query: string): ReadonlySignal<boolean> {
  if (typeof matchMedia === "undefined") return signal(false);
  const list = matchMedia(query);
  const matches = signal(list.matches);
  list.addEventListener("change", () => {
    matches.value = list.matches;
  });
  return matches;
}

const chosen = signal<Theme>(read());
const systemDark = watch("(prefers-color-scheme: dark)");

export const theme: ReadonlySignal<Theme> = chosen;
/** What the choice comes to now. */
export const dark: ReadonlySignal<boolean> = computed(() =>
  chosen.value === "auto" ? systemDark.value : chosen.value === "dark",
);
/** Nothing moves by itself, and nothing eases. */
export const reducedMotion: ReadonlySignal<boolean> = watch("(prefers-reduced-motion: reduce)");

export function setTheme(next: Theme): void {
  chosen.value = next;
  if (next === "auto") delete document.documentElement.dataset["theme"];
  else document.documentElement.dataset["theme"] = next;
  try {
    if (next === "auto") localStorage.removeItem(KEY);
    else localStorage.setItem(KEY, next);
  } catch {
    // Kept for this visit only.
  }
}
