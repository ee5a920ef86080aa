/** Lessons by the words that somebody looks for. */
import { found } from "../find/words";
import { LESSONS, type Lesson, UNITS } from "./course";

/** What a lesson on whether shapes are connected is also looked for by. */
const CONNECTED = /connect|touch|\bgap\b|one piece|holds? together|pieces apart|whole, dust/i;
const IN_PLAIN_WORDS =
  "connected falls apart, falling apart, holds together, hangs together, one piece, whole, in pieces, broken, breaks up, " +
  "separate, split, joined";

/** All that is said of a lesson before it is opened. */
function textOf(lesson: Lesson): string[] {
  const unit = UNITS.find(({ figures }) => figures.includes(lesson));
  const { number, title, about, words } = lesson;
  const own = [number, title, about, words, unit?.title ?? "", unit?.about ?? ""];
  return CONNECTED.test([title, about, words].join(" ")) ? [...own, IN_PLAIN_WORDS] : own;
}

/** The lessons of which each word is said, or the beginning of it. None where nothing is asked. */
export const lessonsWith = (asked: string): Lesson[] => found(LESSONS, asked, textOf, ({ short }) => short);
