/** Who has the keys. */

export interface KeyPress {
  key: string;
  shiftKey: boolean;
  ctrlKey: boolean;
  metaKey: boolean;
  altKey: boolean;
}

/**
 * What has the focus: typing takes every key, a field where nothing typed is waiting leaves the chords, a control keeps
 * the keys that it lives by.
 */
export type Focus = "typing" | "field" | "slider" | "control" | "none";

export function focusOf(target: EventTarget | null): Focus {
  if (!(target instanceof HTMLElement)) return "none";
  if (target.isContentEditable || target.matches("textarea, select")) return "typing";
  if (target instanceof HTMLInputElement) {
    if (target.type === "range") return "slider";
    if (target.type === "radio" || target.type === "checkbox") return "control";
    return target.dataset["settled"] === "true" ? "field" : "typing";
  }
  if (target.getAttribute("role") === "slider") return "slider";
  return target.closest("button, a[href], summary, [role=menu]") === null ? "none" : "control";
}
