/**
 * Formulas as they were typed, for as long as the page is open: a field shows 1/√2, and not 0.7071, while that is its
 * value, also after undo.
 */
const MOST_KEPT = 200;
const LONGEST = 24;
const kept = new Map<string, string>();

/** What a field is known by: its label and its symbol. */
export const fieldName = (label: string, symbol = "") => `${label} ${symbol}`;

/** A value that went through turns and stretches comes back with other last digits. */
const keyOf = (field: string, value: number) => `${field} ${value.toPrecision(14)}`;

/** Keeps what was typed into a field of this name, unless it is plain digits, which the field can write itself. */
export function keepTyped(field: string, value: number, text: string): void {
  const key = keyOf(field, value);
  kept.delete(key);
  const words = text.trim();
  if (words.length > LONGEST || !/[a-z√°^/*+()]/i.test(words.replace(/^[-+]|e[-−+]?\d+$/gi, ""))) return;
  kept.set(key, words);
  for (const oldest of kept.keys()) {
    if (kept.size <= MOST_KEPT) break;
    kept.delete(oldest);
  }
}

/** What was typed for this value into a field of this name. */
export function typedAs(field: string, value: number): string | undefined {
  return kept.get(keyOf(field, value));
}
