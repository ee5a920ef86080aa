/** What the items of a sheet are called, and where they lead. */
import { presets } from "#document/presets";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { LESSONS } from "../course";
import type { Sheet } from "./sheet";

export interface Item {
  /** As `itemsOf` has it. */
  key: string;
  name: string;
  /** Null for what this version of Frond has not. */
  href: string | null;
}

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

export function itemsWithNames({ lessons, shapes, links }: Sheet): Item[] {
  const unknown = "not in this version of Frond";
  return [
    ...lessons.map((id) => {
      const name = lessonName(id);
      return { key: id, name: name ?? `${id}, ${unknown}`, href: name === null ? null : `#learn/${id}` };
    }),
    ...shapes.map((id) => {
      const name = shapeName(id);
      const href = name === null ? null : studioHref({ a: preset(id), b: preset(id) });
      return { key: `shape:${id}`, name: name ?? `${id}, ${unknown}`, href };
    }),
    ...links.map((link, i) => {
      const [, id = ""] = /^learn\/(e\d+)/.exec(link) ?? [];
      const name = lessonName(id);
      return {
        key: `link:${i + 1}`,
        name: name === null ? `Link ${i + 1}` : `${name}, as it was set`,
        href: `#${link}`,
      };
    }),
  ];
}
