/** A reason with its addresses explained, where it has any. */
import * as messages from "./messages";

export function reasonWords(text: string): string {
  const address = /\b(\d)\((\d)\)/.exec(text);
  if (!address) return text;
  const [read = "", first = "", then = ""] = address;
  return messages.addressRead(text, read, first, then);
}
