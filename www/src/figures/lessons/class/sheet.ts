/** A class sheet: lessons, shapes and links that a teacher has chosen. All of it stands in its address. */
import { type Field, flag, list, text, whole } from "../../kit/state/fields";
import { addressOf, valuesIn } from "../../kit/state/page-state";

export interface Sheet {
  title: string;
  /** Lessons, as `e7`. */
  lessons: readonly string[];
  /** Shapes of the gallery, by their ids. */
  shapes: readonly string[];
  /** What stands behind the # of links of Frond: lessons that are set to something, documents of the studio. */
  links: readonly string[];
  /** The number of each link, which it keeps when others come and go: `link:3` is the link with the number 3. */
  numbers: readonly number[];
  /** What links are called, in the teacher's own words, by the names that `itemsOf` gives. */
  names: Readonly<Record<string, string>>;
  /** What is to be done, in the teacher's own words, by the names that `itemsOf` gives. */
  tasks: Readonly<Record<string, string>>;
  /** The names of its items in the order of the teacher's; empty where they are in their usual one. */
  order: readonly string[];
  /** Whether pupils do not see yet what is right. */
  hide: boolean;
}

export const EMPTY: Sheet = {
  title: "",
  lessons: [],
  shapes: [],
  links: [],
  numbers: [],
  names: {},
  tasks: {},
  order: [],
  hide: false,
};

/** More would fit no QR code, and no lesson of a school. */
export const MOST = { title: 80, lessons: 60, shapes: 30, links: 8, link: 900, name: 60, task: 140 };

const TITLE: Field<string> = text(/[^\n\r]{1,80}/u);
const LESSONS = list(text(/e\d{1,4}/), 1, MOST.lessons);
const SHAPES = list(text(/[\w-]{1,32}/), 1, MOST.shapes);
const LINKS = list(text(/\S{1,900}/), 1, MOST.links, " ");
/** Left out where each has that of its place, as in sheets that were made before links had any. */
const NUMBERS = list(text(/[1-9]\d?/), 1, MOST.links);
const NAMES = list(text(/link:\d{1,2} [^\n\r]{1,60}/u), 1, MOST.links, "\n");
/** Which of the items in their usual order comes first, second and so on. */
const ORDER = list(
  whole(1, MOST.lessons + MOST.shapes + MOST.links),
  1,
  MOST.lessons + MOST.shapes + MOST.links,
);
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
  const { title, lessons, shapes, links, numbers, names, tasks } = sheet;
  const values: [string, string][] = [];
  if (title.trim() !== "") values.push(["title", TITLE.write(title.trim())]);
  if (lessons.length > 0) values.push(["lessons", LESSONS.write(lessons)]);
  if (shapes.length > 0) values.push(["shapes", SHAPES.write(shapes)]);
  if (links.length > 0) values.push(["links", LINKS.write(links)]);
  if (numbers.some((number, i) => number !== i + 1))
    values.push(["numbers", NUMBERS.write(numbers.map(String))]);
  const linesOf = (words: Sheet["tasks"], items: readonly string[], most: number) =>
    items.flatMap((item) => {
      const said = (words[item] ?? "").replace(/\s+/g, " ").trim().slice(0, most).trim();
      return said === "" ? [] : [`${item} ${said}`];
    });
  const named = linesOf(names, numbers.map(linkItem), MOST.name);
  if (named.length > 0) values.push(["names", NAMES.write(named)]);
  const lines = linesOf(tasks, itemsOf(sheet), MOST.task);
  if (lines.length > 0) values.push(["tasks", TASKS.write(lines)]);
  const usual = usualOf(sheet);
  const order = itemsOf(sheet).map((item) => usual.indexOf(item) + 1);
  if (order.some((place, i) => place !== i + 1)) values.push(["order", ORDER.write(order)]);
  if (sheet.hide) values.push(["hide", flag.write(true)]);
  return values;
}

/** What a link is to its sheet, by its number. */
export const linkItem = (number: number) => `link:${number}`;

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
  const links = part<readonly string[]>("links", LINKS, []);
  const numbers = part<readonly string[]>("numbers", NUMBERS, []).map(Number);
  if (numbers.length > 0 && (numbers.length !== links.length || new Set(numbers).size < numbers.length)) {
    whole = false;
    numbers.length = 0;
  }
  const numbered = new Map(links.map((link, i) => [link, numbers[i] ?? i + 1]));
  const sheet: Sheet = {
    title: part("title", TITLE, ""),
    lessons: [...new Set(part<readonly string[]>("lessons", LESSONS, []))],
    shapes: [...new Set(part<readonly string[]>("shapes", SHAPES, []))],
    links: [...numbered.keys()],
    numbers: [...numbered.values()],
    names: wordsOf(part<readonly string[]>("names", NAMES, [])),
    tasks: wordsOf(part<readonly string[]>("tasks", TASKS, [])),
    order: [],
    hide: part("hide", flag, false),
  };
  const places = part<readonly number[]>("order", ORDER, []);
  const usual = usualOf(sheet);
  const order = [...new Set(places)].flatMap((place) => usual[place - 1] ?? []);
  if (places.length === 0 || order.length === usual.length) return { sheet: { ...sheet, order }, whole };
  return { sheet, whole: false };
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

type Items = Pick<Sheet, "lessons" | "shapes" | "numbers">;

/** As they come where the teacher has not ordered them. */
function usualOf({ lessons, shapes, numbers }: Items): string[] {
  return [...lessons, ...shapes.map((id) => `shape:${id}`), ...numbers.map(linkItem)];
}

/** What is to be done, each by a name that no other has: its lesson, `shape:` or `link:` and which. */
export function itemsOf({ order = [], ...items }: Items & Partial<Pick<Sheet, "order">>): string[] {
  const usual = usualOf(items);
  // What has been added since it was ordered comes last.
  return [...order.filter((item) => usual.includes(item)), ...usual.filter((item) => !order.includes(item))];
}

/** The sheet with one of its items so many places further on. */
export function moved(sheet: Sheet, item: string, by: number): Sheet {
  const items = itemsOf(sheet);
  const at = items.indexOf(item);
  const to = Math.max(0, Math.min(items.length - 1, at + by));
  if (at < 0 || to === at) return sheet;
  items.splice(at, 1);
  items.splice(to, 0, item);
  return { ...sheet, order: items };
}

/** The state of an address as it is where answers may be seen: what pupils wrote is kept by that. */
export const withoutHiding = (state: string) =>
  state
    .split("&")
    .filter((part) => part !== "hide=1")
    .join("&");

/** Links with the numbers that they keep. */
export type Numbered = Pick<Sheet, "links" | "numbers">;

const MOST_NUMBER = 99;

/**
 * Links that were written in place of others. One that was there keeps its number, and so does one that comes back,
 * whose number is in `known`, and a line that was changed where it stands. A new one has a number that none had.
 */
export function numbered(before: Numbered, written: readonly string[], known: Map<string, number>): Numbered {
  const links = [...new Set(written)];
  const there = new Map(before.links.map((link, i) => [link, before.numbers[i] ?? i + 1]));
  const changed = (i: number) => {
    const old = before.links[i];
    return links.length === before.links.length && old && !links.includes(old) ? there.get(old) : undefined;
  };
  const numbers: (number | undefined)[] = links.map(() => undefined);
  const give = (numberOf: (link: string, i: number) => number | undefined) => {
    for (const [i, link] of links.entries()) {
      const number = numbers[i] ?? numberOf(link, i);
      if (!numbers.includes(number)) numbers[i] = number;
    }
  };
  give((link) => there.get(link));
  give((link) => known.get(link));
  give((_, i) => changed(i));
  let highest = Math.max(0, ...there.values(), ...known.values());
  // After very many changes there is none that none had.
  const free = () =>
    Array.from({ length: MOST_NUMBER }, (_, k) => k + 1).find((one) => !numbers.includes(one));
  give(() => (highest < MOST_NUMBER ? ++highest : free()));
  const given = numbers.map((number, i) => number ?? i + 1);
  for (const [link, number] of there) known.set(link, number);
  for (const [i, link] of links.entries()) known.set(link, given[i] ?? i + 1);
  return { links, numbers: given };
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
