import type { Page } from "@playwright/test";
import { guess, LESSONS, openContents, openFigure, ROWS_OF_FIGURES } from "./figure-pages";
import { expect, test } from "./fixture";

test("no figure is wider than a phone", async ({ page }) => {
  await expectNarrow(page, ["", ...ROWS_OF_FIGURES.flatMap(({ ids }) => ids)]);
});

test("no lesson is wider than a phone", async ({ page }) => {
  await openContents(page);
  expect(await over(page)).toBe(0);
  await expectNarrow(page, LESSONS);
});

async function expectNarrow(page: Page, figures: readonly string[]): Promise<void> {
  for (const figure of figures) {
    await openFigure(page, figure);
    expect(await over(page), figure).toBe(0);
    expect(await wide(page), figure).toEqual([]);
  }
}

/** How far the page scrolls sideways. */
function over(page: Page): Promise<number> {
  return page.getByRole("main").evaluate((main) => main.scrollWidth - main.clientWidth);
}

/** What of a figure is cut off. What scrolls by itself may be wider. */
function wide(page: Page): Promise<string[]> {
  return page.evaluate(() =>
    [...document.querySelectorAll("[data-testid=live] *, [data-testid=exercise] *")]
      .filter((part) => !part.closest("[data-testid=wide-table]") && !part.closest(".unseen"))
      .filter((part) => part.getBoundingClientRect().right > innerWidth + 1)
      .map((part) => `${part.tagName} ${part.getAttribute("class")}`),
  );
}

test("nothing moves on a phone when the truth comes", async ({ page }) => {
  for (const lesson of LESSONS) {
    await openFigure(page, lesson);
    const question = page.getByRole("region", { name: "What do you think?" });
    await question.locator("fieldset input").first().waitFor();
    await guess(page);
    const button = question.getByRole("button", { name: "Show me" });
    const place = (element: typeof button) =>
      element.evaluate(
        (it) => it.getBoundingClientRect().top + (it.closest("main")?.scrollTop ?? Number.NaN),
      );
    // It stands still: all above it is there.
    await button.click({ trial: true });
    const before = await place(button);
    await button.click();
    await question.getByTestId("truth").waitFor();
    const after = await place(question.getByRole("button", { name: "Think again" }));
    expect(after, lesson).toBeCloseTo(before, 0);
  }
});
