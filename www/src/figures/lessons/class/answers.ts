/** What a pupil has done of a sheet, as a file that a teacher opens. What a file says is not trusted. */

export interface Answer {
  /** As `itemsOf` names it. */
  item: string;
  done: boolean;
  /** The exercises that are solved, from 1. */
  exercises: readonly number[];
  /** What was guessed in the lesson before its truth was seen; empty where nothing was. */
  guess: string;
  /** Whether the guess was right, where that is known. */
  right?: boolean;
  /** What is so, in the words of the guess, where that is known. */
  truth?: string;
  /** What it is called on the sheet. */
  name?: string;
  answer: string;
}

export interface Answers {
  name: string;
  /** The title of the sheet. */
  title: string;
  /** When it was saved, as `2026-11-24T10:00:00Z`. */
  saved: string;
  items: readonly Answer[];
}

const KIND = "frond answers";
const VERSION = 1;
/** Far more than anybody writes. */
export const MOST_BYTES = 500_000;
const MOST_ITEMS = 120;
export const MOST_WORDS = 4000;
const MOST_NAME = 80;
const MOST_GUESS = 160;

export function written(answers: Answers): string {
  return `${JSON.stringify({ kind: KIND, version: VERSION, ...answers }, null, 1)}\n`;
}

/** Answers from the text of a file, or in words why it holds none. */
export function read(text: string): Answers | string {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return "This is no file of answers: it is no JSON. Ask for the file that “Save as a file” makes.";
  }
  if (!isRecord(value) || value["kind"] !== KIND) {
    return "This is no file of answers. Ask for the file that “Save as a file” makes.";
  }
  if (typeof value["version"] !== "number" || value["version"] > VERSION) {
    return "These answers are of a later version of Frond. Load this page anew, and open them again.";
  }
  return answersIn(value) ?? "The answers in this file are damaged. Ask for it once more.";
}

/** Answers from what was written in this form; null where some of it cannot be read. */
export function answersIn(value: unknown): Answers | null {
  if (!isRecord(value)) return null;
  const { items } = value;
  if (!Array.isArray(items) || items.length > MOST_ITEMS) return null;
  const read = items.flatMap((item) => answerOf(item) ?? []);
  if (read.length < items.length) return null;
  return {
    name: wordsOf(value["name"], MOST_NAME).trim() || "without a name",
    title: wordsOf(value["title"], MOST_NAME).trim(),
    saved: wordsOf(value["saved"], 40),
    items: read,
  };
}

function answerOf(value: unknown): Answer | null {
  if (!isRecord(value)) return null;
  const { item, done, exercises, guess, right, truth, name, answer } = value;
  if (typeof item !== "string" || !/^(?:e\d{1,4}|shape:[\w-]{1,32}|link:\d{1,2})$/.test(item)) return null;
  if (typeof done !== "boolean" || !Array.isArray(exercises)) return null;
  const solved = exercises.filter((n): n is number => Number.isInteger(n) && n > 0 && n < 100);
  return {
    item,
    done,
    exercises: [...new Set(solved)],
    guess: wordsOf(guess, MOST_GUESS),
    ...(typeof right === "boolean" ? { right } : {}),
    ...(typeof truth === "string" && truth !== "" ? { truth: truth.slice(0, MOST_GUESS) } : {}),
    ...(typeof name === "string" ? { name: name.slice(0, MOST_NAME) } : {}),
    answer: wordsOf(answer, MOST_WORDS),
  };
}

const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

const wordsOf = (value: unknown, most: number) => (typeof value === "string" ? value.slice(0, most) : "");

/** All that was handed in, the latest of each name for each sheet, by names. */
export function latest(all: readonly Answers[]): Answers[] {
  const byName = new Map<string, Answers>();
  for (const answers of all) {
    const before = byName.get(keyOf(answers));
    if (!before || before.saved <= answers.saved) byName.set(keyOf(answers), answers);
  }
  return [...byName.values()].sort((p, q) => p.name.localeCompare(q.name));
}

/** What tells one pupil's answers to one sheet from all others. */
export const keyOf = ({ title, name }: Answers) => JSON.stringify([title, name]);

/** The titles of the sheets that were answered, the one that was handed in last first. */
export function titlesOf(all: readonly Answers[]): string[] {
  const newestFirst = [...all].sort((p, q) => (p.saved < q.saved ? 1 : -1));
  return [...new Set(newestFirst.map(({ title }) => title))];
}

/** What they were asked, in the order in which it first comes. */
export function askedOf(all: readonly Answers[]): string[] {
  return [...new Set(all.flatMap(({ items }) => items.map(({ item }) => item)))];
}
