/** What a text that is pasted is meant as: a link, or what would be a file. */

import * as messages from "./messages";
import { tellPasted } from "./tell";

/** The longest text that is taken from the clipboard. */
const MOST_LETTERS = 16 << 20;
/** The longest link, with the words around it. */
const MOST_OF_A_LINK = 1 << 20;

const BEGINS = "v(?:=|%(?:25)*3D)\\d+(?:&|%(?:25)*26)[\\s\\S]*";
/** A link of a document, alone or behind other words; and its fragment alone. */
const ADDRESS = new RegExp(`[a-z]{2,10}:[^\\s#]{0,2000}#(${BEGINS})`, "i");
const FRAGMENT = new RegExp(`^[\\s<("'“]*#?(${BEGINS})`, "i");

const NOT_MEANT = messages.frondCannotOpenPasted;

/** `nothing`: there is no text. */
export type Pasted = { nothing: true } | { link: string } | { file: File } | { problem: string };

export function pasted(text: string): Pasted {
  if (text.trim() === "") return { nothing: true };
  if (text.length > MOST_LETTERS) {
    return { problem: messages.pastedTextLongerThan };
  }
  const link = text.length <= MOST_OF_A_LINK ? linkIn(text) : null;
  if (link !== null) return { link };
  const kind = tellPasted(text);
  if (kind === null) return { problem: NOT_MEANT };
  const name = {
    outline: messages.pastedOutline,
    maps: messages.pastedMaps,
    animation: messages.pastedAnimation,
  }[kind];
  return { file: new File([text], name, { type: typeOf(text) }) };
}

function linkIn(text: string): string | null {
  return (ADDRESS.exec(text) ?? FRAGMENT.exec(text))?.[1]?.trim() ?? null;
}

/** A table may be a graph, and drawings and JSON are none: tools look at this where they read both. */
function typeOf(text: string): string {
  if (/^\s*</.test(text)) return "image/svg+xml";
  return /^\s*[[{]/.test(text) ? "application/json" : "text/plain";
}
