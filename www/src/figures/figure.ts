/** What a figure or a lesson is to those who list it. */
import type { ComponentType } from "preact";
import type { Heading } from "./kit/frame/frame";
import type { Field } from "./kit/state/fields";

export interface Figure {
  /** The last part of its address, `#figures/7` or `#learn/e1`; further ones lead to the same page. */
  id: string;
  also?: readonly string[];
  /** As the paper counts. */
  number: string;
  /** The same in the row of all figures. */
  short: string;
  title: string;
  /** One line for the index. */
  about: string;
  load(): Promise<PageModule>;
  thumb(): Promise<SmallPicture>;
}

export interface PageModule extends Needing {
  Page: ComponentType<Heading>;
  /** What of it stands in its address, by name. */
  STATE?: Readonly<Record<string, readonly [first: unknown, field: Field<unknown>]>>;
}

/** A small picture, made by the same parts as the figure itself. */
export interface SmallPicture extends Needing {
  Thumb: ComponentType;
}

/** The small pictures of a row, by the ids of its figures. */
export type Thumbs = Readonly<Record<string, SmallPicture>>;

/** Fetches the small pictures of a row, and takes that of one figure. */
export async function thumbFrom(fetched: Promise<{ THUMBS: Thumbs }>, id: string): Promise<SmallPicture> {
  const found = (await fetched).THUMBS[id];
  if (!found) throw new Error(`There is no small picture of ${id}.`);
  return found;
}

interface Needing {
  /** What must be there before it is shown. */
  needs?: readonly (() => Promise<unknown>)[];
}

/** The figures of a paper, or the lessons of a unit. */
export interface Row {
  id: string;
  name: string;
  /** Who wrote it, as each page of a paper says. */
  paper?: string;
  title: string;
  about: string;
  figures: readonly Figure[];
}
