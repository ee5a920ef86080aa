/** Fetches the page of a figure or its small picture, with what that needs. */
import type { ComponentType } from "preact";
import { once } from "#wasm/module";
import type { Figure, PageModule, SmallPicture } from "./figure";
import type { Heading } from "./kit/frame/frame";

const pages = new Map<Figure, () => Promise<ComponentType<Heading>>>();

/** A page, fetched once; again if that failed. */
export function pageOf(figure: Figure): Promise<ComponentType<Heading>> {
  const page = pages.get(figure) ?? once(async () => (await ready(figure.load())).Page);
  pages.set(figure, page);
  return page();
}

export async function thumbOf(figure: Figure): Promise<ComponentType> {
  return (await ready(figure.thumb())).Thumb;
}

/** A page or a small picture, once all is there that it needs. */
async function ready<T extends PageModule | SmallPicture>(fetched: Promise<T>): Promise<T> {
  const { needs = [] } = await fetched;
  await Promise.all(needs.map((load) => load()));
  return fetched;
}
