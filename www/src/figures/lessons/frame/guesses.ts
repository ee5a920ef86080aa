/** What was guessed in each lesson when its truth was first looked at; kept in this browser and told to nobody. */
const KEY = "frond.guesses";
const MOST_WORDS = 160;
const MOST_LESSONS = 200;

/** What was kept, by lessons; what is no guess is left out. */
export function guessesIn(text: string | null): Map<string, string> {
  try {
    const value: unknown = JSON.parse(text ?? "{}");
    if (typeof value !== "object" || value === null) return new Map();
    const all = Object.entries(value).filter(
      (entry): entry is [string, string] => /^e\d{1,4}$/.test(entry[0]) && typeof entry[1] === "string",
    );
    return new Map(all.slice(0, MOST_LESSONS).map(([lesson, words]) => [lesson, words.slice(0, MOST_WORDS)]));
  } catch {
    return new Map();
  }
}

function kept(): Map<string, string> {
  try {
    return guessesIn(localStorage.getItem(KEY));
  } catch {
    return new Map();
  }
}

/** The first guess of a lesson; empty where there was none. */
export const guessOf = (lesson: string) => kept().get(lesson) ?? "";

const RIGHT = "frond.guesses-right";

/** The lessons whose first guess was right, and those where it was not, in what was kept. */
export function rightIn(text: string | null): Map<string, boolean> {
  try {
    const value: unknown = JSON.parse(text ?? "{}");
    if (typeof value !== "object" || value === null) return new Map();
    const all = Object.entries(value).filter(
      (entry): entry is [string, boolean] => /^e\d{1,4}$/.test(entry[0]) && typeof entry[1] === "boolean",
    );
    return new Map(all.slice(0, MOST_LESSONS));
  } catch {
    return new Map();
  }
}

function keptRight(): Map<string, boolean> {
  try {
    return rightIn(localStorage.getItem(RIGHT));
  } catch {
    return new Map();
  }
}

/** Whether the first guess of a lesson was right; null where it is not known. */
export const rightOf = (lesson: string) => keptRight().get(lesson) ?? null;

const TRUTH = "frond.guesses-truth";

function keptTruth(): Map<string, string> {
  try {
    return guessesIn(localStorage.getItem(TRUTH));
  } catch {
    return new Map();
  }
}

/** What was so, in the words of the guess; empty where it is not known. */
export const truthOf = (lesson: string) => keptTruth().get(lesson) ?? "";

/** A second guess, once the truth is known, is none. */
export function keepGuess(lesson: string, words: string): void {
  const all = kept();
  if (all.has(lesson) || words === "") return;
  write(KEY, all.set(lesson, words.slice(0, MOST_WORDS)));
}

/** What is so, once it is known, beside the guess that was kept. */
export function keepTruth(lesson: string, words: string, right: boolean, truth: string): void {
  if (words === "" || truth === "" || rightOf(lesson) !== null) return;
  if (guessOf(lesson) !== words.slice(0, MOST_WORDS)) return;
  write(RIGHT, keptRight().set(lesson, right));
  write(TRUTH, keptTruth().set(lesson, truth.slice(0, MOST_WORDS)));
}

function write(key: string, all: ReadonlyMap<string, string | boolean>): void {
  try {
    localStorage.setItem(key, JSON.stringify(Object.fromEntries(all)));
  } catch {
    // Then nobody hears of it.
  }
}

/** As if nobody had guessed. */
export function clearGuesses(): void {
  try {
    localStorage.removeItem(KEY);
    localStorage.removeItem(RIGHT);
    localStorage.removeItem(TRUTH);
  } catch {
    // There are none.
  }
}

/** What an answer is called that can be ticked: its words, without those of a drawing. */
function nameOf(input: Element): string {
  const name = input.closest("label")?.querySelector("input + *")?.cloneNode(true);
  if (!(name instanceof Element)) return "";
  for (const drawing of name.querySelectorAll("svg")) drawing.replaceWith(" ");
  return (name.textContent ?? "").replace(/\s+/g, " ").trim();
}

/** A guess in words: what is ticked, as it is called, else the number. */
export function guessWords(question: Element | null, guess: unknown): string {
  const ticked = [...(question?.querySelectorAll("fieldset input:checked") ?? [])].map(nameOf);
  return ticked.length > 0 ? ticked.join("; ") : typeof guess === "number" ? String(guess) : "";
}

/** What is so in the same words. */
export function truthWords(question: Element | null, truth: string | readonly string[] | number): string {
  if (typeof truth === "number") return String(Number(truth.toFixed(4)));
  if (typeof truth !== "string") return truth.join("; ");
  const all = [...(question?.querySelectorAll<HTMLInputElement>("fieldset input") ?? [])];
  return all
    .filter(({ value }) => value === truth)
    .map(nameOf)
    .join("; ");
}
