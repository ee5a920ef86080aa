import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type { Page } from "@playwright/test";
import type { AxeResults, RunOptions } from "axe-core";
import { expect } from "./fixture";

const source = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** The rules that hang on colours: what else there is to find, a page has in either theme. */
const COLOUR_RULES = ["color-contrast", "link-in-text-block"];

/**
 * Nothing on the page, or in a part of it, stands in the way of anybody, in either theme. Motion is reduced for it, and
 * stays so: no colour is half-way between two. The page has no frames, so that axe runs in it as it is; telling of the
 * rules that are kept would take four times as long.
 */
export async function expectClean(page: Page, part = "html"): Promise<void> {
  await page.emulateMedia({ colorScheme: "light", reducedMotion: "reduce" });
  await expectNone(page, part, {});
  await page.emulateMedia({ colorScheme: "dark" });
  await expectNone(page, part, { runOnly: COLOUR_RULES });
  await page.emulateMedia({ colorScheme: "light" });
}

async function expectNone(page: Page, part: string, options: RunOptions): Promise<void> {
  if (!(await page.evaluate(() => "axe" in window))) await page.evaluate(source);
  const found = await page.evaluate(
    async ({ part, options }) => {
      const { axe } = window as unknown as {
        axe: { run(part: string, options: RunOptions): Promise<AxeResults> };
      };
      // What follows the theme by a listener has followed it by then.
      for (let frames = 0; frames < 2; frames++) await new Promise(requestAnimationFrame);
      const { violations } = await axe.run(part, options);
      return violations.map(
        ({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(" ")).join(", ")}`,
      );
    },
    { part, options: { ...options, resultTypes: ["violations" as const] } },
  );
  expect(found).toEqual([]);
}
