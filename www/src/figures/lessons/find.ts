/** Lessons by the words that somebody looks for. */
import { LESSONS, type Lesson, UNITS } from "./course";

/** What is compared: letters and digits alone, and no marks on letters. */
const plain = (words: string) =>
  words
    .toLowerCase()
    .normalize("NFD")
    .replace(/\p{Mark}/gu, "")
    .replace(/[^\p{Letter}\p{Number}]+/gu, " ")
    .trim();

/** All that is said of a lesson before it is opened. */
function textOf(lesson: Lesson): string {
  const unit = UNITS.find(({ figures }) => figures.includes(lesson));
  return ` ${plain([lesson.number, lesson.title, lesson.about, lesson.words, unit?.title, unit?.about].join(" "))}`;
}

/** The lessons of which each word is said, or the beginning of it; in their order. None where nothing is asked. */
export function lessonsWith(asked: string): Lesson[] {
  const words = plain(asked).split(" ");
  if (words[0] === "") return [];
  return LESSONS.filter((lesson) => {
    const text = textOf(lesson);
    return words.every((word) => text.includes(` ${word}`));
  });
}
