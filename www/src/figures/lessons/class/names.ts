/** What the items of a sheet are called, and where they lead. */
import { presets } from "#document/presets";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { LESSONS } from "../course";
import { itemsOf, linkItem, type Sheet } from "./sheet";

export interface Item {
  /** As `itemsOf` has it. */
  key: string;
  name: string;
  /** Null for what this version of Frond has not. */
  href: string | null;
  /** What is to be done, in the teacher's own words, or else what there is to do with a shape. */
  task: string;
  /** A shape of the gallery, by its id. */
  shape?: string;
}

/** What a shape alone, opened where it is bent, is good for. */
export const SHAPE_TASK = "Pull its handles: which parts follow, and how?";

export function lessonName(id: string): string | null {
  const lesson = LESSONS.find((one) => one.id === id);
  return lesson ? `${lesson.number}, ${lesson.title}` : null;
}

export function shapeName(id: string): string | null {
  return presets().find((one) => one.id === id)?.name ?? null;
}

/** By the name of the item alone, as a file of answers has it. */
export function nameOf(item: string): string {
  if (item.startsWith("shape:")) return shapeName(item.slice(6)) ?? item;
  if (item.startsWith("link:")) return `Link ${item.slice(5)}`;
  return lessonName(item) ?? item;
}

/** What a link is called that its sheet has no name for. */
export function plainLinkName(link: string, number: number): string {
  const [, id = ""] = /^learn\/(e\d+)/.exec(link) ?? [];
  const name = lessonName(id);
  return name === null ? `Link ${number}` : `${name}, as it was set`;
}

export function itemsWithNames(sheet: Sheet): Item[] {
  const { lessons, shapes, links, numbers, names, tasks, hide } = sheet;
  const places = itemsOf(sheet);
  const taskOf = (key: string) => tasks[key] ?? "";
  const unknown = "not in this version of Frond";
  const all: Item[] = [
    ...lessons.map((id) => {
      const name = lessonName(id);
      return {
        key: id,
        name: name ?? `${id}, ${unknown}`,
        href: name === null ? null : hiding(`#learn/${id}`, hide),
        task: taskOf(id),
      };
    }),
    ...shapes.map((id) => {
      const name = shapeName(id);
      const key = `shape:${id}`;
      if (name === null) return { key, name: `${id}, ${unknown}`, href: null, task: taskOf(key) };
      // Alone, and with something to do: a morph of a shape into itself has nothing to show.
      const href = studioHref({ a: preset(id), b: preset(id), tool: "deform" });
      return { key, name, href, task: taskOf(key) || SHAPE_TASK, shape: id };
    }),
    ...links.map((link, i) => {
      const number = numbers[i] ?? i + 1;
      const key = linkItem(number);
      const name = names[key]?.trim() || plainLinkName(link, number);
      return { key, name, href: hiding(`#${link}`, hide), task: taskOf(key) };
    }),
  ];
  return all.sort((p, q) => places.indexOf(p.key) - places.indexOf(q.key));
}

/** A lesson that is opened from a sheet which hides answers does not show its own. */
function hiding(href: string, hide: boolean): string {
  if (!hide || !/^#learn\/e\d+/.test(href)) return href;
  return /^#learn\/e\d+\/./.test(href) ? `${href}&hide=1` : `${href.replace(/\/$/, "")}/hide=1`;
}
