import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type { Page } from "@playwright/test";
import type { AxeResults, RunOptions } from "axe-core";
import { expect } from "./fixture";

const source = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** The rules that hang on colours: what else there is to find, a page has in either theme. */
const COLOUR_RULES = ["color-contrast", "link-in-text-block"];

/**
 * Nothing on the page, or in a part of it, stands in the way of anybody. The page has no frames, so that axe runs in it
 * as it is; telling of the rules that are kept would take four times as long.
 */
export function expectClean(page: Page, part = "html"): Promise<void> {
  return expectNone(page, part, {});
}

/** The same of the colours alone, for a second theme. */
export function expectClear(page: Page, part = "html"): Promise<void> {
  return expectNone(page, part, { runOnly: COLOUR_RULES });
}

async function expectNone(page: Page, part: string, options: RunOptions): Promise<void> {
  if (!(await page.evaluate(() => "axe" in window))) await page.evaluate(source);
  const found = await page.evaluate(
    async ({ part, options }) => {
      const { axe } = window as unknown as {
        axe: { run(part: string, options: RunOptions): Promise<AxeResults> };
      };
      const { violations } = await axe.run(part, options);
      return violations.map(
        ({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(" ")).join(", ")}`,
      );
    },
    { part, options: { ...options, resultTypes: ["violations" as const] } },
  );
  expect(found).toEqual([]);
}
