import { openFigure } from "./figure-pages";
import { expect, test } from "./fixture";

test("what two shapes of a grid share follows keys, numbers and the choice of shapes", async ({ page }) => {
  await openFigure(page, "s10");
  const verdict = page.getByRole("status").filter({ has: page.locator("strong") });
  await page.getByRole("combobox", { name: "Grid" }).selectOption("line-3");
  await page.getByRole("spinbutton", { name: /Parts of a unit/ }).fill("4");
  await page.keyboard.press("Enter");
  const across = page.getByRole("spinbutton", { name: /^x, so many parts/ });
  await across.fill("1");
  await page.keyboard.press("Enter");
  await expect(verdict).toContainText("It is an attractor again, of 2 maps.");
  await expect(verdict).toContainText("Dimension 0.3155");
  // Where it is seen it is moved, too: by a quarter, three times, to the end of the first.
  const picture = page.getByRole("application", { name: /Cantor’s set.* moved by 1\/4/ });
  await picture.focus();
  for (let k = 0; k < 3; k++) await page.keyboard.press("ArrowRight");
  await expect(across).toHaveValue("4");
  await expect(verdict).toContainText("They share one point.");
  await page.getByRole("combobox", { name: "First shape" }).selectOption("wide");
  await expect(verdict).toContainText("Dimension at most");
  // What is made of several kinds of pieces opens as a shape of as many states.
  await page.getByRole("link", { name: "Open what they share" }).click();
  await expect(
    page.getByRole("button", { name: /^Shape A: What two shapes share, \d+ states/ }),
  ).toBeVisible();
});
