import { expect, test } from "./fixture";

test("no figure is wider than a phone", async ({ page }) => {
  for (const figure of [
    "",
    "/1",
    "/2",
    "/3",
    "/5",
    "/6",
    "/7",
    "/table-1",
    "/e1",
    "/e2",
    "/e3",
    "/e4",
    "/e5",
    "/e6",
    "/e7",
    "/e8",
    "/e9",
    "/e10",
  ]) {
    await page.goto("about:blank");
    await page.goto(`./#figures${figure}`);
    await page.getByRole("heading", { level: 1 }).waitFor();
    const over = await page.getByRole("main").evaluate((main) => main.scrollWidth - main.clientWidth);
    expect(over, figure).toBe(0);
  }
});
