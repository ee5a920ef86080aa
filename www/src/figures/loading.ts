/** Fetches what a figure's folder holds, with what that needs. */
import type { ComponentType } from "preact";
import { once } from "#wasm/module";
import type { Figure, PageModule, ThumbModule } from "./figure";
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

/** A module, once all is there that it needs. */
async function ready<T extends PageModule | ThumbModule>(module: Promise<T>): Promise<T> {
  const { needs = [] } = await module;
  await Promise.all(needs.map((load) => load()));
  return module;
}
