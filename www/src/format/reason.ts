/** A reason with its addresses explained, where it has any. */
export function reasonWords(text: string): string {
  const address = /\b(\d)\((\d)\)/.exec(text);
  if (!address) return text;
  const [read, first, then] = address;
  return `${text} (${read} reads: in piece ${first}, in its part ${then}, in the part ${then} of that, and so on for ever.)`;
}
