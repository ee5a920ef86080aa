import { openFigure } from "./figure-pages";
import { expect, test } from "./fixture";

// The tab is that of all tests, so that it has to be asked for here.
test.beforeEach(({ page }) => page.context().grantPermissions(["clipboard-read", "clipboard-write"]));

test("a formula is drawn by the browser, and copied as LaTeX by keys", async ({ page }) => {
  await openFigure(page, "e4");
  const copy = page.getByRole("button", { name: "Copy as LaTeX" }).first();
  await copy.focus();
  await expect(copy).toHaveCSS("opacity", "1");
  await page.keyboard.press("Enter");
  await expect(page.getByText("The formula is copied as LaTeX.")).toBeVisible();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe("f_1(x) = r x");
  // A raised letter stands higher than the one that it belongs to: MathML, and no plain text.
  const [two, n] = await page
    .locator("math msup")
    .first()
    .evaluate((it) => [...it.children].map((part) => part.getBoundingClientRect().bottom));
  expect(n).toBeLessThan(two ?? 0);
});

test("words that are copied bring their formulas as LaTeX", async ({ page }) => {
  await openFigure(page, "e4");
  await page.evaluate(() => {
    const [paragraph] = [...document.querySelectorAll("p")].filter((it) => it.querySelector("math"));
    if (paragraph) getSelection()?.selectAllChildren(paragraph);
  });
  await page.keyboard.press("Control+c");
  expect(await page.evaluate(() => navigator.clipboard.readText())).toContain(
    "step $n$ has $2^n$ of them, and no part of a piece is farther from its own than the bars reach, $r^{n+1}$.",
  );
});
