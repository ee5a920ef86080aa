import { type ReadonlySignal, signal } from "@preact/signals";

/** Whether a media query holds, kept up to date. False where there is no screen. */
export function media(query: string): ReadonlySignal<boolean> {
  if (typeof matchMedia === "undefined") return signal(false);
  const list = matchMedia(query);
  const matches = signal(list.matches);
  list.addEventListener("change", () => {
    matches.value = list.matches;
  });
  return matches;
}
