/** The figures and lessons, read from the list of the page as text: what they import does not concern the build. */
import { readFileSync } from "node:fs";

export interface ListedFigure {
  id: string;
  number: string;
  title: string;
  about: string;
}

/** In the order of the list. */
export function listedFigures(): ListedFigure[] {
  const text = readFileSync(new URL("../src/figures/list.ts", import.meta.url), "utf8");
  const entry =
    /id: "([^"]+)",(?:\s+also: \[[^\]]*\],)?\s+number: "([^"]+)",\s+short: "[^"]+",\s+title:\s+"([^"]+)",\s+about:\s+"([^"]+)",/g;
  return [...text.matchAll(entry)].map(([, id = "", number = "", title = "", about = ""]) => ({
    id,
    number,
    title,
    about,
  }));
}
