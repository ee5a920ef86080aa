import type { Page } from "@playwright/test";
import { expect, test } from "./fixture";

test.use({ alone: true });

/** The studio, for somebody who has never been here. */
async function visitFirst(page: Page): Promise<void> {
  await page.addInitScript(() => {
    if (location.protocol === "about:" || sessionStorage.getItem("visited") !== null) return;
    sessionStorage.setItem("visited", "");
    localStorage.removeItem("frond.guide");
  });
  await page.goto("./");
}

const t = (page: Page) => page.evaluate(() => window.frond?.scene().t ?? Number.NaN);

test("a first visit sees all of the way once and is told what it is", async ({ page }) => {
  await visitFirst(page);
  const welcome = page.getByRole("complementary", { name: "Welcome" });
  await expect(welcome).toContainText("Frond turns one fractal into another without letting it fall apart.");
  await expect(welcome.getByRole("status")).toHaveText("Each colour is a smaller copy of the full shape.");
  const top = () => page.locator(".stage").evaluate((stage) => stage.getBoundingClientRect().top);
  const before = await top();
  await expect.poll(() => t(page), { timeout: 30_000 }).toBe(1);
  await expect(page.getByRole("button", { name: "Play" })).toBeVisible();
  await expect(welcome.getByRole("status")).toHaveText("Now it is Gasket. Press play to watch it again.");
  expect(await top()).toBe(before);
  await welcome.getByRole("button", { name: "Close" }).click();
  await expect(welcome).toHaveCount(0);
  await page.goto("about:blank");
  await page.goto("./");
  await page.waitForFunction(() => window.frond?.idle());
  await expect(welcome).toHaveCount(0);
});

test("the word of welcome leaves with the morph that it speaks of", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await visitFirst(page);
  const welcome = page.getByRole("complementary", { name: "Welcome" });
  await expect(welcome).toBeVisible();
  await page.getByRole("button", { name: "Edit the maps of A" }).click();
  await expect(welcome).toHaveCount(0);
  await page.evaluate(() => sessionStorage.removeItem("visited"));
  await page.goto("about:blank");
  await page.goto("./");
  await expect(welcome).toBeVisible();
  await page.getByRole("navigation", { name: "Places" }).getByRole("link", { name: "Fit" }).click();
  await expect(welcome).toHaveCount(0);
});

test("whoever wants less motion sees none, and who follows a link is told what it is", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await visitFirst(page);
  await expect(page.getByRole("complementary", { name: "Welcome" })).toBeVisible();
  expect(await t(page)).toBe(0);
  await expect(page.getByRole("complementary", { name: "Welcome" }).getByRole("status")).toHaveText(
    "Press play to watch Dragon of three turn into Gasket.",
  );
  await page.evaluate(() => sessionStorage.removeItem("visited"));
  await page.goto("about:blank");
  await page.goto("./#a=koch&b=gasket&t=0.3");
  await expect(page.getByRole("complementary", { name: "Welcome" })).toContainText("turns into Gasket.");
  await page.evaluate(() => window.frond?.idle());
  expect(await t(page)).toBe(0.3);
  // Its steps are about what Frond begins with, and what was sent is there to go back to.
  await page.getByRole("button", { name: "Take the tour" }).click();
  await expect(page.getByRole("heading", { name: "Press play" })).toBeFocused();
  await expect(page.getByRole("button", { name: /^Shape A: Dragon of three/ })).toBeVisible();
  await page.goBack();
  await expect(page.getByRole("button", { name: /^Shape A: Koch/ })).toBeVisible();
});

test("the word of welcome lies over nothing", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  for (const [width, height] of [
    [390, 844],
    [844, 390],
    [1280, 800],
  ] as const) {
    await page.setViewportSize({ width, height });
    await visitFirst(page);
    const welcome = page.getByRole("complementary", { name: "Welcome" });
    const box = await welcome.boundingBox();
    if (!box) throw new Error("nobody is welcomed");
    expect(box.x + box.width).toBeLessThanOrEqual(width);
    expect(box.y + box.height).toBeLessThanOrEqual(height);
    for (const part of [".stage", ".time", ".side", ".header"]) {
      const other = await page.locator(part).boundingBox();
      if (!other) throw new Error(`there is no ${part}`);
      const across = Math.min(box.x + box.width, other.x + other.width) - Math.max(box.x, other.x);
      const down = Math.min(box.y + box.height, other.y + other.height) - Math.max(box.y, other.y);
      expect(Math.min(across, down), `${part} at ${width} x ${height}`).toBeLessThanOrEqual(0.5);
    }
    await page.evaluate(() => sessionStorage.removeItem("visited"));
    await page.goto("about:blank");
  }
});

test("the round leads over the real controls, by keyboard, and goes on where it was left", async ({
  page,
}) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await visitFirst(page);
  await page.getByRole("button", { name: "Take the tour" }).click();
  const card = page.getByRole("complementary", { name: "Press play" });
  await expect(card.getByRole("heading", { name: "Press play" })).toBeFocused();
  await page.getByRole("button", { name: "Play" }).click();
  await expect(card.getByText("Done.")).toBeVisible();
  await page.getByRole("button", { name: "Pause" }).click();
  await card.getByRole("button", { name: "Next" }).click();
  await expect(page.getByRole("heading", { name: "Now try the straight path" })).toBeFocused();
  await page.getByRole("radio", { name: "Straight" }).check({ force: true });
  await expect(page.getByText("Done.")).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(page.getByRole("heading", { name: "Now try the straight path" })).toHaveCount(0);
  // Help has it still.
  await page.keyboard.press("?");
  await page.getByRole("dialog").getByRole("button", { name: "Take the tour" }).click();
  await expect(page.getByRole("heading", { name: "Now try the straight path" })).toBeFocused();
  // So does a page that was loaded anew in the midst of it.
  await page.reload();
  await expect(page.getByRole("heading", { name: "Now try the straight path" })).toBeFocused();
  for (const title of ["The locus shows why", "Go around", "Ask why"]) {
    await page.getByRole("button", { name: "Next" }).click();
    await expect(page.getByRole("heading", { name: title })).toBeFocused();
  }
  await page.getByTestId("verdict").click();
  await expect(page.getByText("Done.")).toBeVisible();
  await page.getByRole("link", { name: "Go to the lessons" }).click();
  await expect(page.getByRole("heading", { level: 1, name: "Learn" })).toBeVisible();
});

test("help explains the words, and leads to their lessons", async ({ page, studio }) => {
  await studio.open();
  await page.keyboard.press("?");
  await page.getByText("Glossary").click();
  await page.getByRole("link", { name: "Lesson on “gap”" }).click();
  await expect(page.getByRole("heading", { level: 1, name: "Why three differs from two" })).toBeVisible();
  await page.goBack();
  await expect(page.getByRole("dialog")).toHaveCount(0);
});
