/** What is found by the words that somebody looks for: lessons, figures, sections of papers. */

/** What is compared: letters and digits, the dots within "3.6", and no marks on letters. */
const plain = (words: string) =>
  words
    .toLowerCase()
    .normalize("NFD")
    .replace(/\p{Mark}/gu, "")
    .replace(/[^\p{Letter}\p{Number}.]+/gu, " ")
    .replace(/(?<!\p{Number})\.|\.(?!\p{Number})/gu, " ")
    .trim()
    .split(/ +/);

/** Words that are left out of what is asked, unless nothing else is: "Burch and Hart". */
const SMALL = new Set(["a", "al", "and", "by", "et", "in", "of", "on", "the", "to"]);

/** The words that are looked for; none where nothing is asked. */
function wordsIn(asked: string): string[] {
  const words = plain(asked).filter((word) => word !== "");
  const large = words.filter((word) => !SMALL.has(word));
  return large.length > 0 ? large : words;
}

const isNumber = (word: string) => /^[\p{Number}.]+$/u.test(word);

/** A word is found by its beginning; a number is a whole one: 3 is 3, or the beginning of 3.6, and not that of 31. */
function says(text: readonly string[], asked: string): boolean {
  return text.includes(asked) || text.some((word) => word.startsWith(isNumber(asked) ? `${asked}.` : asked));
}

/**
 * Those of which each word is said; none where nothing is asked. `textOf` is all that is said of one. First come those
 * whose own number is asked for, then those that say each number as it is asked for, and else they keep their order.
 */
export function found<T>(
  all: readonly T[],
  asked: string,
  textOf: (one: T) => readonly string[],
  numberOf: (one: T) => string,
): T[] {
  const words = wordsIn(asked);
  if (words.length === 0) return [];
  const numbers = words.filter(isNumber);
  const ranked = all.flatMap((one) => {
    const text = plain(textOf(one).join(" "));
    if (!words.every((word) => says(text, word))) return [];
    const exact = numbers.every((word) => text.includes(word));
    return { one, rank: words.includes(numberOf(one)) ? 0 : exact ? 1 : 2 };
  });
  return ranked.sort((p, q) => p.rank - q.rank).map(({ one }) => one);
}
