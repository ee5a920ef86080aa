import { ALL, idsOf, open } from "./figure-pages";
import { expect, test } from "./fixture";

test("no figure is wider than a phone", async ({ page }) => {
  for (const figure of ["", ...ALL]) {
    await open(page, figure);
    const over = await page.getByRole("main").evaluate((main) => main.scrollWidth - main.clientWidth);
    expect(over, figure).toBe(0);
  }
});

test("nothing moves on a phone when the truth comes", async ({ page }) => {
  for (const lesson of idsOf("lessons")) {
    await open(page, lesson);
    const question = page.getByRole("region", { name: "What do you think?" });
    const input = question.locator("fieldset input").first();
    await input.waitFor();
    if ((await input.getAttribute("type")) !== "range") await input.check();
    const button = question.getByRole("button", { name: "Show me" });
    const place = (element: typeof button) =>
      element.evaluate(
        (it) => it.getBoundingClientRect().top + (it.closest("main")?.scrollTop ?? Number.NaN),
      );
    const before = await place(button);
    await button.click();
    await question.locator(".truth").waitFor();
    const after = await place(question.getByRole("button", { name: "Think again" }));
    expect(after, lesson).toBeCloseTo(before, 0);
  }
});
