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
  /** What links are called, in the teacher's own words, by the names that `itemsOf` gives. */
  names: Readonly<Record<string, string>>;
  /** What is to be done, in the teacher's own words, by the names that `itemsOf` gives. */
  tasks: Readonly<Record<string, string>>;
}

export const EMPTY: Sheet = { title: "", lessons: [], shapes: [], links: [], names: {}, tasks: {} };

/** More would fit no QR code, and no lesson of a school. */
export const MOST = { title: 80, lessons: 60, shapes: 30, links: 8, link: 900, name: 60, task: 140 };

const TITLE: Field<string> = text(/[^\n\r]{1,80}/u);
const LESSONS = list(text(/e\d{1,4}/), 1, MOST.lessons);
const SHAPES = list(text(/[\w-]{1,32}/), 1, MOST.shapes);
const LINKS = list(text(/\S{1,900}/), 1, MOST.links, " ");
const NAMES = list(text(/link:\d{1,2} [^\n\r]{1,60}/u), 1, MOST.links, "\n");
/** A line for each: its name, a space, and words. */
const TASKS = list(
  text(/(?:e\d{1,4}|shape:[\w-]{1,32}|link:\d{1,2}) [^\n\r]{1,140}/u),
  1,
  MOST.lessons + MOST.shapes + MOST.links,
  "\n",
);

/** The state of an address as it is written. */
export const sheetAddress = (sheet: Sheet) => addressOf(valuesOf(sheet));

/** Whether an address holds it, and opens again. */
export const fits = (sheet: Sheet) => sheetIn(sheetAddress(sheet))?.whole === true;

/** A sheet in the making as it is kept; it may hold nothing yet, or too much. */
export const sheetKept = (sheet: Sheet) => JSON.stringify(Object.fromEntries(valuesOf(sheet)));

/** What was kept, as far as it is a sheet. */
export function sheetOfKept(text: string | null): Sheet {
  try {
    const value: unknown = JSON.parse(text ?? "{}");
    const kept = new Map(Object.entries(typeof value === "object" && value !== null ? value : {}));
    const words = (name: string) => {
      const one = kept.get(name);
      return typeof one === "string" ? one : undefined;
    };
    return sheetOf(words).sheet;
  } catch {
    return EMPTY;
  }
}

function valuesOf(sheet: Sheet): [string, string][] {
  const { title, lessons, shapes, links, names, tasks } = sheet;
  const values: [string, string][] = [];
  if (title.trim() !== "") values.push(["title", TITLE.write(title.trim())]);
  if (lessons.length > 0) values.push(["lessons", LESSONS.write(lessons)]);
  if (shapes.length > 0) values.push(["shapes", SHAPES.write(shapes)]);
  if (links.length > 0) values.push(["links", LINKS.write(links)]);
  const linesOf = (words: Sheet["tasks"], items: readonly string[], most: number) =>
    items.flatMap((item) => {
      const said = (words[item] ?? "").replace(/\s+/g, " ").trim().slice(0, most).trim();
      return said === "" ? [] : [`${item} ${said}`];
    });
  const named = linesOf(names, links.map(linkItem), MOST.name);
  if (named.length > 0) values.push(["names", NAMES.write(named)]);
  const lines = linesOf(tasks, itemsOf(sheet), MOST.task);
  if (lines.length > 0) values.push(["tasks", TASKS.write(lines)]);
  return values;
}

const linkItem = (_: string, i: number) => `link:${i + 1}`;

/** A sheet from an address; null where it holds none. What cannot be read of it is left out, and said by `whole`. */
export function sheetIn(state: string): { sheet: Sheet; whole: boolean } | null {
  const values = valuesIn(state);
  if (!values) return null;
  const found = sheetOf((name) => values.get(name));
  return itemsOf(found.sheet).length === 0 ? null : found;
}

function sheetOf(written: (name: string) => string | undefined): { sheet: Sheet; whole: boolean } {
  let whole = true;
  const part = <T>(name: string, field: Field<T>, otherwise: T): T => {
    const words = written(name);
    if (words === undefined) return otherwise;
    const value = field.read(words);
    if (value === null) whole = false;
    return value ?? otherwise;
  };
  const sheet: Sheet = {
    title: part("title", TITLE, ""),
    lessons: [...new Set(part<readonly string[]>("lessons", LESSONS, []))],
    shapes: [...new Set(part<readonly string[]>("shapes", SHAPES, []))],
    links: [...new Set(part<readonly string[]>("links", LINKS, []))],
    names: wordsOf(part<readonly string[]>("names", NAMES, [])),
    tasks: wordsOf(part<readonly string[]>("tasks", TASKS, [])),
  };
  return { sheet, whole };
}

/** The words of each line behind the name that it begins with. */
function wordsOf(lines: readonly string[]): Record<string, string> {
  return Object.fromEntries(
    lines.map((line) => {
      const end = line.indexOf(" ");
      return [line.slice(0, end), line.slice(end + 1)];
    }),
  );
}

/** What is to be done, each by a name that no other has: its lesson, `shape:` or `link:` and which. */
export function itemsOf({ lessons, shapes, links }: Pick<Sheet, "lessons" | "shapes" | "links">): string[] {
  return [...lessons, ...shapes.map((id) => `shape:${id}`), ...links.map(linkItem)];
}

/** The sheet that a link leads to; null for any other link. */
export function sheetOfLink(link: string): Sheet | null {
  const [, state = ""] = /#learn\/(?:sheet|class)\/(\S+)$/.exec(link.trim()) ?? [];
  return sheetIn(state)?.sheet ?? null;
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
