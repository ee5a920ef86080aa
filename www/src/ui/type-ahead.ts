/** Without case and accents: who types "levy" means the Lévy curve. */
const plain = (name: string) => name.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase();

/**
 * The place of the name that begins with what was typed, from the present one on and round; the same letter again and
 * again goes to the next of those that begin with it. −1 where there is none.
 */
export function placeTyped(names: readonly string[], now: number, text: string): number {
  const wanted = plain(text);
  const again = wanted.length > 1 && [...wanted].every((letter) => letter === wanted[0]);
  const begins = again ? wanted.slice(0, 1) : wanted;
  // Of a longer text the present one may still be meant.
  const first = wanted.length === 1 || again ? now + 1 : now;
  for (let i = 0; i < names.length; i++) {
    const at = (first + i) % names.length;
    if (plain(names[at] ?? "").startsWith(begins)) return at;
  }
  return -1;
}
