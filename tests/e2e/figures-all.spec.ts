import { readFileSync } from "node:fs";
import type { Locator, Page } from "@playwright/test";
import { decodeScene, initSync } from "../../www/pkg/frond-first.js";
import { expectClean } from "./axe";
import { expectDrawn, expectShape, guess, openFigure, ROWS_OF_FIGURES, UNITS } from "./figure-pages";
import { expect, test } from "./fixture";

/** Where the page is from: one on an open question is nobody's. */
const badge = (page: Page) => page.getByTestId("badge");

for (const { name, ids } of ROWS_OF_FIGURES) {
  test(`${name}: every figure says where it is from, is drawn, clean in both themes, and leads into the studio`, async ({
    page,
  }) => {
    await page.emulateMedia({ reducedMotion: "reduce" });
    const links: string[] = [];
    for (const figure of ids) {
      await test.step(figure, async () => {
        await openFigure(page, figure);
        if (figure !== "s9") await expect(badge(page)).toHaveText(/^(as printed|reconstructed|Frond’s own)$/);
        if (figure === "c7") await stopFit(page);
        await expectDrawn(page);
        if (name === "Figures of space") await expectShape(page);
        await expectClean(page);
        links.push(...(await studioLinks(page)));
      });
    }
    expect(links.length).toBeGreaterThan(0);
    await expectOpening(page, links);
  });
}

for (const { title, ids } of UNITS) {
  test(`Lessons, ${title}: every one asks before it tells, is clean in both themes, and leads into the studio`, async ({
    page,
  }) => {
    await page.emulateMedia({ reducedMotion: "reduce" });
    const links: string[] = [];
    for (const lesson of ids) {
      await test.step(lesson, async () => {
        await openFigure(page, lesson);
        await expect(badge(page)).toHaveText("by Frond");
        // The finished picture: more than one colour on it, and words for those who do not see it.
        const picture = page.getByRole("region", { name: "The picture" }).getByRole("img").first();
        await expect(picture).toHaveAccessibleName(/\w+ \w+/);
        await expect.poll(() => picture.evaluate(coloursOf)).toBeGreaterThan(1);
        await expectClean(page);
        await expect(page.getByTestId("exercise")).not.toHaveCount(0);
        await expect(page.getByTestId("exercise").locator("[data-solved]")).toHaveCount(0);
        await expectHandout(page);
        await expectAnswer(page);
        links.push(...(await studioLinks(page)));
      });
    }
    await expectOpening(page, links);
  });
}

/** A prediction by keys alone, and then the truth beside it. */
async function expectAnswer(page: Page): Promise<void> {
  const question = page.getByRole("region", { name: "What do you think?" });
  await expect(question.getByTestId("truth")).toHaveCount(0);
  await expect(question.getByRole("button", { name: "Show me" })).toBeDisabled();
  await guess(page);
  const button = question.getByRole("button", { name: "Show me" });
  await button.focus();
  const before = await placeOf(button);
  await page.keyboard.press("Enter");
  await expect(question.getByTestId("truth")).toBeVisible();
  const again = question.getByRole("button", { name: "Think again" });
  await expect(again).toBeFocused();
  // What was there stays where it was.
  expect(await placeOf(again)).toBeCloseTo(before, 0);
  await expectClean(page);
  await page.keyboard.press("Enter");
  await expect(question.getByTestId("truth")).toHaveCount(0);
}

/** One page to read and guess, one of exercises; no answers, also where the page shows them. */
async function expectHandout(page: Page): Promise<void> {
  await page.emulateMedia({ media: "print" });
  for (const format of ["A4", "Letter"]) {
    const pdf = (await page.pdf({ format })).toString("latin1");
    expect(pdf.match(/\/Type \/Page\b/g)?.length, format).toBe(2);
  }
  await page.emulateMedia({ media: null });
  const teachers = page.locator("details", { has: page.locator("summary", { hasText: "For teachers" }) });
  const summary = teachers.locator("summary");
  const answers = teachers.locator(":scope > :not(summary)");
  await summary.click();
  await expect(answers).toBeVisible();
  const event = (name: string) => page.evaluate((name) => dispatchEvent(new Event(name)) && 0, name);
  await event("beforeprint");
  await page.emulateMedia({ media: "print" });
  await expect(answers).toBeHidden();
  await page.emulateMedia({ media: null });
  await event("afterprint");
  await summary.click();
}

/** How far down the page an element begins. */
function placeOf(element: Locator): Promise<number> {
  return element.evaluate(
    (it) => it.getBoundingClientRect().top + (it.closest("main")?.scrollTop ?? Number.NaN),
  );
}

/** How many colours a canvas holds, or a drawing uses. */
function coloursOf(picture: Element): number {
  if (!(picture instanceof HTMLCanvasElement)) {
    const parts = [...picture.querySelectorAll("path, circle, rect, polygon")];
    return new Set(parts.map((part) => getComputedStyle(part).stroke + getComputedStyle(part).fill)).size;
  }
  const image = picture.getContext("2d")?.getImageData(0, 0, picture.width, picture.height);
  return image ? new Set(new Uint32Array(image.data.buffer)).size : 0;
}

/** Lets the leaf's fit come far enough to be seen, and no farther. */
async function stopFit(page: Page): Promise<void> {
  const curve = page.getByRole("img", { name: /^Frond’s closed curve of 290 numbers/ });
  await expect(curve).toHaveAccessibleName(/% off$/);
  await page.getByRole("button", { name: "Stop" }).click();
  await expect(page.getByRole("img", { name: /^Where two of 29 copies/ })).toHaveAccessibleName(/a gap of/);
}

/** Where the page leads into the studio. */
function studioLinks(page: Page): Promise<string[]> {
  return page
    .getByTestId("studio-link")
    .evaluateAll((all) => all.map((a) => a.getAttribute("href") ?? "no address"));
}

initSync({ module: readFileSync(new URL("../../www/pkg/frond-first_bg.wasm", import.meta.url)) });

/**
 * Links of figures are links of the studio, of the tool that they name: what reads them in the page reads all of them
 * here. The page opens the first of each tool, and all whose tool reads a part of its own.
 */
async function expectOpening(page: Page, links: readonly string[]): Promise<void> {
  const tools = new Set<string | undefined>();
  for (const link of links) {
    const tool = new URLSearchParams(link.slice(1)).get("tool") ?? undefined;
    const { scene, problem } = decodeScene(link.slice(1));
    expect([problem, scene.tool], link).toEqual([undefined, tool]);
    if (tools.has(tool) && tool !== "space" && tool !== "fit") continue;
    tools.add(tool);
    await page.evaluate((link) => location.assign(link), link);
    await expect.poll(() => page.evaluate(() => window.frond?.scene().tool)).toBe(tool);
    await expect(page.getByRole("alert")).toHaveCount(0);
  }
}
