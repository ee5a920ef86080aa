/** The figures and lessons, read from the list of the page as text: what they import does not concern the build. */
import { readFileSync } from "node:fs";

export interface ListedFigure {
  id: string;
  number: string;
  title: string;
  about: string;
}

const read = (file: string) => readFileSync(new URL(`../src/figures/${file}`, import.meta.url), "utf8");

/** In the order of the lists. */
export function listedFigures(): ListedFigure[] {
  return [...figures(), ...lessons()];
}

/** Lessons are numbered as they come. */
function lessons(): ListedFigure[] {
  const entry = /id: "([^"]+)",\s+title:\s+"([^"]+)",\s+about:\s+"([^"]+)",\s+minutes: /g;
  return [...read("lessons/course.ts").matchAll(entry)].map(([, id = "", title = "", about = ""], i) => ({
    id,
    number: `Lesson ${i + 1}`,
    title,
    about,
  }));
}

function figures(): ListedFigure[] {
  const entry =
    /id: "([^"]+)",(?:\s+also: \[[^\]]*\],)?\s+number: "([^"]+)",\s+short: "[^"]+",\s+title:\s+"([^"]+)",\s+about:\s+"([^"]+)",/g;
  return [...read("list.ts").matchAll(entry)].map(([, id = "", number = "", title = "", about = ""]) => ({
    id,
    number,
    title,
    about,
  }));
}
