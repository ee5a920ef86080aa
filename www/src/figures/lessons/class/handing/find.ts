/** Pupils' answers in whatever text they come in: links, words, mails with quotes, lists with names. */
import { type Answers, read } from "../answers";
import { bytesOf, lengthOf } from "./code";
import { unpacked } from "./pack";

/** So it stands before a code in links and words; in a link within a link the sign is written otherwise. */
export const BEFORE = "answers=";
const BEGIN = /answers(?:=|%3D)/gi;
/** A class is smaller, and so are all classes of a school. */
export const MOST_CODES = 2000;
/** The longest code has fewer signs, and what mails put between them. */
const WINDOW = 60_000;
/** What mails and chats put between the signs of a code: ends of lines, quote marks, what is not seen. */
const BETWEEN = /[\s>|=\u00ad\u200b-\u200f\u2060\ufeff]/g;
/** Fewer letters are a word of a sentence. */
const LEAST = 12;
/** Of a form that is not known, only what can be nothing else is taken for one. */
const LEAST_LATER = 40;
const ALL_FIGURES = /^1\d{60,}$/;

export interface Found {
  answers: Answers[];
  /** Codes of which a part is missing or other than it was. */
  damaged: number;
  /** Codes that only a later version of Frond reads. */
  later: number;
  /** Whether there were more than are read at once. */
  more: boolean;
}

/** All answers in a text. */
export function codesIn(text: string): Found {
  const found: Found = { answers: [], damaged: 0, later: 0, more: false };
  const whole = text.trim();
  if (ALL_FIGURES.test(whole)) {
    note(found, codeAt(whole));
    return found;
  }
  if (whole.startsWith("{") && whole.length < WINDOW * 10) {
    const file = read(whole);
    if (typeof file !== "string") return { ...found, answers: [file] };
  }
  const seen = new Set<string>();
  for (const { 0: sign, index } of text.matchAll(BEGIN)) {
    const from = index + sign.length;
    const code = codeAt(text.slice(from, from + WINDOW));
    if (code === null || seen.has(code)) continue;
    // A mail quotes the one before it.
    seen.add(code);
    if (seen.size > MOST_CODES) {
      found.more = true;
      break;
    }
    note(found, code);
  }
  return found;
}

/** The code that a text begins with, as far as it is there; null where it begins with none. */
function codeAt(text: string): string | null {
  const begun = text.slice(0, 200);
  const run = /^[\s\u200b\ufeff]*([0-9A-Za-z]*)/.exec(begun)?.[1] ?? "";
  const length = lengthOf(begun.replace(BETWEEN, ""));
  if (length !== null) {
    const next = text.search(BEGIN);
    const own = (next < 0 ? text : text.slice(0, next)).slice(0, 4 * length + 200).replace(BETWEEN, "");
    const joined = /^[0-9A-Za-z]*/.exec(own)?.[0] ?? "";
    if (joined.length >= length) return joined.slice(0, length);
  }
  return run.length < LEAST || !/^(?:[A-Z]|\d)/.test(run) ? null : run;
}

function note(found: Found, code: string | null): void {
  if (code === null) return;
  // Other letters are for forms that come later.
  if (!/^[A1]/.test(code)) {
    if (code.length >= LEAST_LATER) found.later++;
    return;
  }
  const bytes = bytesOf(code);
  const one = bytes === null ? "damaged" : unpacked(bytes);
  if (one === "damaged") found.damaged++;
  else if (one === "later") found.later++;
  else found.answers.push(one);
}
