/** A class sheet: lessons, shapes and links that a teacher has chosen. All of it stands in its address. */
import { type Field, list, text } from "../../kit/state/fields";
import { addressOf, valuesIn } from "../../kit/state/page-state";

export interface Sheet {
  title: string;
  /** Lessons, as `e7`. */
  lessons: readonly string[];
  /** Shapes of the gallery, by their ids. */
  shapes: readonly string[];
  /** What stands behind the # of links of Frond: lessons that are set to something, documents of the studio. */
  links: readonly string[];
}

export const EMPTY: Sheet = { title: "", lessons: [], shapes: [], links: [] };

/** More would fit no QR code, and no lesson of a school. */
export const MOST = { title: 80, lessons: 60, shapes: 30, links: 8, link: 900 };

const TITLE: Field<string> = text(/[^\n\r]{1,80}/u);
const LESSONS = list(text(/e\d{1,4}/), 1, MOST.lessons);
const SHAPES = list(text(/[\w-]{1,32}/), 1, MOST.shapes);
const LINKS = list(text(/\S{1,900}/), 1, MOST.links, " ");

/** The state of an address as it is written. */
export function sheetAddress({ title, lessons, shapes, links }: Sheet): string {
  const values: [string, string][] = [];
  if (title.trim() !== "") values.push(["title", TITLE.write(title.trim())]);
  if (lessons.length > 0) values.push(["lessons", LESSONS.write(lessons)]);
  if (shapes.length > 0) values.push(["shapes", SHAPES.write(shapes)]);
  if (links.length > 0) values.push(["links", LINKS.write(links)]);
  return addressOf(values);
}

/** A sheet from an address; null where it holds none. What cannot be read of it is left out, and said by `whole`. */
export function sheetIn(state: string): { sheet: Sheet; whole: boolean } | null {
  const values = valuesIn(state);
  if (!values) return null;
  let whole = true;
  const part = <T>(name: string, field: Field<T>, otherwise: T): T => {
    const written = values.get(name);
    if (written === undefined) return otherwise;
    const value = field.read(written);
    if (value === null) whole = false;
    return value ?? otherwise;
  };
  const sheet: Sheet = {
    title: part("title", TITLE, ""),
    lessons: [...new Set(part<readonly string[]>("lessons", LESSONS, []))],
    shapes: [...new Set(part<readonly string[]>("shapes", SHAPES, []))],
    links: [...new Set(part<readonly string[]>("links", LINKS, []))],
  };
  return itemsOf(sheet).length === 0 ? null : { sheet, whole };
}

/** What is to be done, each by a name that no other has: its lesson, `shape:` or `link:` and which. */
export function itemsOf({ lessons, shapes, links }: Sheet): string[] {
  return [...lessons, ...shapes.map((id) => `shape:${id}`), ...links.map((_, i) => `link:${i + 1}`)];
}

/** What stands behind the # of each line of a text; `wrong` are the lines that hold no link of Frond. */
export function linksIn(written: string): { links: string[]; wrong: string[] } {
  const lines = written.split(/\s+/).filter((line) => line !== "");
  const links: string[] = [];
  const wrong: string[] = [];
  for (const line of lines) {
    const [, fragment = ""] = /#(\S+)$/.exec(line) ?? [];
    const isLink = /^(?:learn\/e\d{1,4}|figures\/[\w-]+)(?:\/|$)|^(?:\w+=|[\w-]+$)/.test(fragment);
    if (isLink && fragment.length <= MOST.link && links.length < MOST.links) links.push(fragment);
    else wrong.push(line);
  }
  return { links, wrong };
}
