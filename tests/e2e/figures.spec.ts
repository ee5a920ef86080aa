import type { Page } from "@playwright/test";
import { expectClean } from "./axe";
import { guess, LESSONS, look, openContents, openFigure, ROWS_OF_FIGURES } from "./figure-pages";
import { expect, test } from "./fixture";

test("the index shows every figure, drawn and clean", async ({ page }) => {
  await openFigure(page, "");
  await expectCards(page, ROWS_OF_FIGURES.flatMap(({ ids }) => ids).length);
  await expectClean(page);
});

test("the contents show every lesson, drawn and clean, and what is done", async ({ page }) => {
  await openContents(page);
  await expectCards(page, LESSONS.length);
  await openFigure(page, "e1");
  await guess(page);
  await page.getByRole("button", { name: "Show me" }).click();
  await openContents(page);
  await expect(page.getByText(`Question answered in 1 of ${LESSONS.length} lessons.`)).toBeVisible();
  await expect(page.getByRole("link", { name: /Two pieces that touch.* question answered$/ })).toBeVisible();
  await expectClean(page);
  await page.reload();
  await expect(page.getByText(`Question answered in 1 of ${LESSONS.length} lessons.`)).toBeVisible();
  await page.getByRole("button", { name: "Clear the marks" }).click();
  await expect(page.getByRole("link", { name: /^Begin: / })).toBeVisible();
});

test("the way back from a lesson leads to where the contents were left", async ({ page }) => {
  await openContents(page);
  const main = page.getByRole("main");
  const last = main.getByRole("link", { name: /Lesson \d+/ }).last();
  await last.scrollIntoViewIfNeeded();
  const at = await main.evaluate((it) => it.scrollTop);
  expect(at).toBeGreaterThan(100);
  await last.click();
  await expect(page.getByRole("heading", { name: "What do you think?" })).toBeVisible();
  await page.goBack();
  await expect.poll(() => main.evaluate((it) => it.scrollTop)).toBeCloseTo(at, -1);
});

async function expectCards(page: Page, count: number): Promise<void> {
  const cards = page
    .getByRole("main")
    .getByRole("link")
    .filter({ has: page.locator("strong") });
  await expect(cards).toHaveCount(count);
  for (const card of await cards.all()) {
    await card.scrollIntoViewIfNeeded();
    const picture = card.locator("canvas, svg").first();
    await expect(picture).toBeAttached();
    if (await picture.evaluate((element) => element instanceof HTMLCanvasElement)) {
      await expect.poll(async () => (await look(picture)).lit).toBeGreaterThan(0.001);
    }
  }
}

test("the chaos game takes its throws by keys", async ({ page }) => {
  await openFigure(page, "e2");
  await page.getByRole("button", { name: "1, lower left" }).focus();
  for (const key of ["1", "2", "3", "3"]) await page.keyboard.press(key);
  await expect(page.getByText("9 throws, the last towards 3")).toBeVisible();
  await page.getByRole("region", { name: "The picture" }).getByRole("button", { name: "Clear" }).click();
  await expect(page.getByText("0 throws", { exact: true })).toBeVisible();
});

test("the overlap graph is compared line by line", async ({ page }) => {
  await openFigure(page, "e3");
  for (const pair of ["1 and 2", "2 and 3"]) await page.getByRole("checkbox", { name: pair }).check();
  await expect(page.getByText("You drew 2 lines. With them the curve would be in 2 groups.")).toBeVisible();
  await page.getByRole("button", { name: "Show me" }).click();
  await expect(page.getByText("1 and 2, 3 and 4 touch: 2 groups, so the curve is in pieces.")).toBeVisible();
  await expect(page.getByText("You left out 3 and 4. You joined 2 and 3, which are apart.")).toBeVisible();
});

test("what pixels hide is measured", async ({ page }) => {
  await openFigure(page, "e5");
  await guess(page);
  await page.getByRole("button", { name: "Show me" }).click();
  await expect(page.getByTestId("truth")).toContainText(/Here 75 pixels say connected from 0\.49\d\d on/);
  await expect(page.getByRole("row", { name: /^pair subdivision/ })).toContainText(/0\.49999\d\d|0\.5000000/);
});

test("a morph can be led across by keys", async ({ page }) => {
  await openFigure(page, "e7");
  await guess(page);
  await page.getByRole("button", { name: "Show me" }).click();
  await expect(page.getByTestId("truth")).toContainText("It first breaks at 0.55");
  await expect(page.getByText(/^widest gap 4\.\d%/)).toBeVisible();
  const question = page.getByRole("region", { name: "What do you think?" });
  const turn = question.getByRole("slider", { name: /^Waypoint u/ });
  for (let i = 0; i < 10; i++) await turn.press("ArrowLeft");
  await expect(page.getByText(/^No gap seen/).first()).toBeVisible();
});

test("the set M is shown, with its landmarks", async ({ page }) => {
  await openFigure(page, "e8");
  await page.getByRole("radio", { name: "In one piece" }).check();
  await page.getByRole("button", { name: "Show me" }).click();
  const map = page.getByRole("img", { name: /^The set M/ });
  await expect.poll(() => look(map).then(({ colours }) => colours)).toBeGreaterThan(50);
  await page.getByRole("button", { name: /, dust$/ }).click();
  await expect(page.getByText("gap 0.033%")).toBeVisible();
  await page.getByRole("button", { name: /^½ \+ ½i/ }).click();
  await expect(page.getByText(/^The twin-dragon, whose/)).toBeVisible();
});

test("the pairing that holds is found", async ({ page }) => {
  await openFigure(page, "e10");
  await page.getByRole("radio", { name: /^P/ }).check();
  await page.getByRole("button", { name: "Show me" }).click();
  await expect(page.getByText("You said P. Q holds together.")).toBeVisible();
  await expect(page.getByText("In pieces", { exact: true })).toHaveCount(2);
  await expect(page.getByText("No gap seen", { exact: true })).toHaveCount(1);
});

test("an exercise says how far one is, gives hints, and stays marked once it is solved", async ({ page }) => {
  await openFigure(page, "e16");
  const exercise = page.getByRole("region", { name: /^Exercise 1/ });
  const field = exercise.getByRole("textbox", { name: "Your address" });
  await field.fill("4");
  await expect(exercise.getByText("There is no piece 4")).toBeVisible();
  await field.fill("1(2)");
  await expect(exercise.getByText("1(2) leads to a point 0.500 away from it.")).toBeVisible();
  await exercise.getByRole("button", { name: "A hint" }).click();
  await expect(exercise.getByText("Hint 1:")).toBeVisible();
  await field.fill("3(1)");
  await expect(exercise.getByText("Solved.")).toBeVisible();
  await field.fill("3");
  await expect(exercise.getByText("Solved.")).toHaveCount(0);
  await expect(exercise.getByRole("heading")).toHaveText(/solved/);
});

test("one leads to the next, and an unknown one to all", async ({ page }) => {
  await page.goto("./#figures/4");
  await page.getByRole("navigation", { name: "Before and after" }).getByRole("link").last().click();
  await expect(page.getByRole("heading", { level: 1 })).toBeFocused();
  await expect(page).toHaveTitle(/^Figure 5/);
  await page.goto("./#figures/nonsense");
  await expect(page.getByText("There is no figure “nonsense”")).toBeVisible();
});

test("Figure 1 proves below one half only", async ({ page }) => {
  await openFigure(page, "1");
  const next = page.getByRole("button", { name: "Next iteration" });
  while (await next.isEnabled()) await next.click();
  await expect(page.getByText("by the bounds of iteration 4")).toBeVisible();
  const r = page.getByRole("slider", { name: "Scale r" });
  for (let i = 0; i < 6; i++) await r.press("ArrowRight");
  while (await next.isEnabled()) await next.click();
  await expect(page.getByText("Nothing proved", { exact: true })).toBeVisible();
});

test("Figure 2 gains its edges and loses them again", async ({ page }) => {
  await openFigure(page, "2");
  await page.getByRole("radio", { name: "100", exact: true }).check();
  for (let i = 0; i < 3; i++) await page.getByRole("button", { name: "Plot 100 more" }).click();
  await expect(page.getByText("1 meets 3")).toBeVisible();
  await expect(page.getByText("as far as 31 pixels tell")).toBeVisible();
  await page.getByRole("button", { name: "Clear" }).click();
  await expect(page.getByText("3 groups", { exact: true })).toBeVisible();
});

test("Figures 3 and 4 part half-way", async ({ page }) => {
  await openFigure(page, "3");
  const time = page.getByRole("slider", { name: "Time t" });
  for (let i = 0; i < 15; i++) await time.press("ArrowRight");
  await expect(page.getByText("determinant of map 1: 0.000")).toBeVisible();
  await expect(page.getByText("determinant of map 1: 0.250")).toBeVisible();
  const film = page.getByRole("list", { name: "Figure 3: frames" }).getByRole("button");
  await expect(film.filter({ hasText: "in pieces" })).toHaveCount(7);
  await expect(film.filter({ hasText: /one piece|no gap seen/ })).toHaveCount(2);
});

test("Figure 5 breaks where Figure 6 holds", async ({ page }) => {
  await openFigure(page, "5");
  const broken = page.getByRole("main").getByRole("button").filter({ hasText: "in pieces" });
  // "Particularly in the latter half", says the paper.
  await expect(broken).toHaveCount(5);
  await page.getByRole("navigation", { name: "Figures" }).getByRole("link", { name: "Figure 6" }).click();
  await expect(page.getByText(/none of \d+ moments is/)).toBeVisible({ timeout: 30_000 });
  await expect(
    page
      .getByRole("main")
      .getByRole("button")
      .filter({ hasText: /one piece|no gap seen/ }),
  ).toHaveCount(10);
  await expect(broken).toHaveCount(0);
});

test("Figure 7 says what lies under the ring", async ({ page }) => {
  await openFigure(page, "7");
  const turn = page.getByRole("slider", { name: "u, turn and stretch" });
  await expect(turn).toHaveAttribute("aria-valuetext", /in pieces, gap/);
  await turn.press("Home");
  await expect(turn).toHaveAttribute("aria-valuetext", /in one piece, proved|no gap seen/);
  await expect(page.getByText("all computed")).toBeVisible({ timeout: 30_000 });
});

test("Table 1 measures, stops and goes on", async ({ page }) => {
  await openFigure(page, "table-1");
  await page.getByRole("button", { name: "Stop" }).click();
  await expect(page.getByText(/^stopped after/).first()).toBeVisible();
  await page.getByRole("radio", { name: "100 000", exact: true }).check();
  await expect(page.getByText(/^\d+ buffers in/).first()).toBeVisible({ timeout: 45_000 });
  const row = page.getByRole("row", { name: /^75 × 75/ });
  await expect(row).toContainText("0.47850");
  const [, middle] = /0\.47850\s*(0\.\d+)/.exec((await row.textContent()) ?? "") ?? [];
  expect(Number(middle)).toBeGreaterThan(0.4785);
  expect(Number(middle)).toBeLessThan(0.5);
});

test.describe("without a connection", () => {
  test.use({ alone: true, expected: /page-.*\.js|Failed to (load|fetch)/ });

  test("a page that cannot be fetched says what to do, and comes at the next try", async ({ page }) => {
    await openFigure(page, "");
    await page.route(/\/page-[^/]*\.js$/, (route) => route.abort());
    await page.getByRole("link", { name: /^Table 1/ }).click();
    await expect(page.getByRole("alert")).toContainText(/Table 1 could not be loaded/);
    // What was there stays.
    await expect(page.getByRole("heading", { level: 1 })).toHaveText("Figures");
    await page.unrouteAll();
    await page.getByRole("button", { name: "Try again" }).click();
    await expect(page).toHaveTitle(/^Table 1/);
    await expect(page.getByRole("alert")).toHaveCount(0);
  });
});

test("a lesson is printed to its end, and the page around it is not", async ({ page }) => {
  await openFigure(page, "e1");
  // All of it: the page before it has a heading, too.
  await page.locator("[data-step=question]").first().waitFor();
  // On paper this small it takes several sheets; what is clipped to the window takes one.
  const pdf = (await page.pdf({ format: "A5" })).toString("latin1");
  expect(pdf.match(/\/Type \/Page\b/g)?.length).toBeGreaterThan(1);
  await page.emulateMedia({ media: "print" });
  await expect(page.getByRole("banner")).toBeHidden();
  await page.emulateMedia({ media: null });
});
