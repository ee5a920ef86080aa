import { expect, it } from "vitest";
import type { Figure } from "./figure";
import { pageOf, thumbOf } from "./loading";

const Page = () => null;
const Thumb = () => null;
const figure = (load: Figure["load"]): Figure => ({
  id: "new",
  number: "Figure 0",
  short: "0",
  title: "None",
  about: "Nothing.",
  load,
  thumb: async () => ({ Thumb }),
});

it("gives a page when all that it needs is there, and fetches it once", async () => {
  let fetched = 0;
  let needed = 0;
  const needs = [
    async () => {
      needed++;
    },
  ];
  const one = figure(async () => {
    fetched++;
    return { Page, needs };
  });
  expect(await Promise.all([pageOf(one), pageOf(one)])).toEqual([Page, Page]);
  expect([fetched, needed]).toEqual([1, 1]);
  expect(await thumbOf(one)).toBe(Thumb);
});

it("tries again after a failure, of the page or of what it needs", async () => {
  let tries = 0;
  const flaky = figure(async () => {
    if (++tries === 1) throw new Error("offline");
    const needs = [
      async () => {
        if (tries === 2) throw new Error("no module");
      },
    ];
    return { Page, needs };
  });
  await expect(pageOf(flaky)).rejects.toThrow("offline");
  await expect(pageOf(flaky)).rejects.toThrow("no module");
  expect(await pageOf(flaky)).toBe(Page);
});
