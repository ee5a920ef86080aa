/** The pages of the package's functions: their samples run, under the policy of the page, and the search finds. */
import { expectClean } from "./axe";
import { expect, test } from "./fixture";

const PAGES = ["draw", "proof", "curve", "fit", "space", "directed", "exchange", "morph"];

test("every sample runs on its page", async ({ page }) => {
  let count = 0;
  for (const name of PAGES) {
    await page.goto(`./api/${name}.html`);
    for (const sample of await page.locator(".sample").all()) {
      const button = sample.getByRole("button");
      const function_ = await button.getAttribute("data-sample");
      await button.click();
      await expect(button).not.toHaveAttribute("aria-disabled");
      if ((await sample.locator("code").textContent())?.includes("canvas"))
        await expect(sample.getByRole("img"), `${function_}`).toBeVisible();
      else await expect(sample.locator("output"), `${function_}`).toHaveText(/\w/);
      await expect(sample.locator("output"), `${function_}`).not.toContainText(/fail|Error|undefined is/);
      count++;
    }
  }
  expect(count).toBeGreaterThanOrEqual(15);
});

test("what is sought is found, from each page", async ({ page }) => {
  await page.goto("./api/draw.html");
  await page.getByRole("searchbox").fill("whether attractor connected");
  await page.getByRole("searchbox").press("Enter");
  await expect(page).toHaveURL(/\/api\/index\.html\?q=whether\+attractor\+connected$/);
  await expect(page.getByRole("listitem")).toHaveText([/^connectedness /]);
  await page.getByRole("searchbox").fill("no such function");
  await expect(page.getByRole("status")).toHaveText("Nothing has these words.");
  await page.getByRole("searchbox").fill("rasterize");
  await page.getByRole("link", { name: "rasterize", exact: true }).click();
  await expect(page).toHaveURL(/\/api\/draw\.html#rasterize$/);
  await expectClean(page);
});
