/** Lessons by the words that somebody looks for. */
import { found } from "../find/words";
import { LESSONS, type Lesson, UNITS } from "./course";

/** All that is said of a lesson before it is opened. */
function textOf(lesson: Lesson): string[] {
  const unit = UNITS.find(({ figures }) => figures.includes(lesson));
  return [lesson.number, lesson.title, lesson.about, lesson.words, unit?.title ?? "", unit?.about ?? ""];
}

/** The lessons of which each word is said, or the beginning of it. None where nothing is asked. */
export const lessonsWith = (asked: string): Lesson[] => found(LESSONS, asked, textOf, ({ short }) => short);
