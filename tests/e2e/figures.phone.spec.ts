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
    "/d1",
    "/d2",
    "/d3",
    "/d4",
    "/d5",
    "/d6",
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
    "/e11",
  ]) {
    await page.goto("about:blank");
    await page.goto(`./#figures${figure}`);
    await page.getByRole("heading", { level: 1 }).waitFor();
    const over = await page.getByRole("main").evaluate((main) => main.scrollWidth - main.clientWidth);
    expect(over, figure).toBe(0);
  }
});

test("nothing moves on a phone when the truth comes", async ({ page }) => {
  for (let lesson = 1; lesson <= 11; lesson++) {
    await page.goto("about:blank");
    await page.goto(`./#figures/e${lesson}`);
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
    expect(after, `lesson ${lesson}`).toBeCloseTo(before, 0);
  }
});
