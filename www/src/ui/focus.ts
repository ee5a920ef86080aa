/** Who has the keys. */

export interface KeyPress {
  key: string;
  /** The place of the key, named as on an American keyboard. */
  code: string;
  shiftKey: boolean;
  ctrlKey: boolean;
  metaKey: boolean;
  altKey: boolean;
}

const BRACKETS: Record<string, string> = { BracketLeft: "[", BracketRight: "]" };

/**
 * The key as an American keyboard has it, where the layout has a letter there that no command is called by: under a
 * Russian, Greek or Hebrew layout, and for brackets under a German one. "?" is found where either keyboard has it.
 */
export function latinKey({ key, code, shiftKey }: Pick<KeyPress, "key" | "code" | "shiftKey">): string {
  if (key.length === 1 && key > "\u007f") {
    const letter = BRACKETS[code] ?? /^Key([A-Z])$/.exec(code)?.[1] ?? key;
    return shiftKey ? letter : letter.toLowerCase();
  }
  // A comma is what a Russian keyboard has there.
  return shiftKey && code === "Slash" && /^[,.]$/.test(key) ? "?" : key;
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
