import { test as base, findNoProofs } from "../e2e/fixture";
import { listen } from "../e2e/studio";
import { open } from "./browsers";
import type { Opened } from "./opened";

/** As those of `tests/e2e`, which fail where the page complains, with a page of the browser that the project names. */
export const test = base.extend<{ told: undefined }, { opened: Opened }>({
  opened: [
    // biome-ignore lint/correctness/noEmptyPattern: Playwright reads from it what a fixture needs.
    async ({}, use, { project }) => {
      const opened = await open(project.name);
      await use(opened);
      await opened.close();
    },
    { scope: "worker" },
  ],
  page: async ({ opened }, use) => {
    const page = await opened.newPage();
    await listen(page);
    await findNoProofs(page);
    // Whoever is new here is greeted, which has tests of its own.
    await page.addInitScript(() => {
      if (location.protocol.startsWith("http")) localStorage["frond.guide"] ??= "seen";
    });
    await use(page);
    await page.context().close();
  },
  told: [
    // What listens is there before, and leaves after.
    async ({ opened, page, quiet: _ }, use) => {
      await use(undefined);
      await opened.listen?.(page);
    },
    { auto: true },
  ],
});

export { expect } from "../e2e/fixture";
