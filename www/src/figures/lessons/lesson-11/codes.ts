/** Which code a code is read as, all its letters but the first few turned round: Fujimoto and others, eq 5. */

export function turned(code: string, kept: number): string {
  return code.slice(0, kept) + [...code.slice(kept)].reverse().join("");
}

/** What is wrong with an answer, in words; empty where it is right. */
export function problem(code: string, kept: number, said: string): string {
  if (said === turned(code, kept)) return "";
  if (said.length < code.length) return `A code of ${code.length} letters has ${code.length} letters again.`;
  if (said === code) return "This is the code itself: nothing is turned round.";
  if (kept > 0 && said === turned(code, 0))
    return "The first letter was turned round with the others; it is to stay.";
  if ([...said].sort().join("") !== [...code].sort().join(""))
    return "The letters are the same, only in another order.";
  return "These are the letters, but not in this order. Read the code from its end.";
}
