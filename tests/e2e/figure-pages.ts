import type { Locator, Page } from "@playwright/test";
import { LESSONS as COURSE, UNITS as COURSE_UNITS } from "../../www/src/figures/lessons/course";
import { ROWS } from "../../www/src/figures/list";
import { expect } from "./fixture";

/** Every row of figures, from the page's own lists: a new figure is tested like the others. */
export const ROWS_OF_FIGURES: readonly { name: string; ids: string[] }[] = ROWS.map(({ name, figures }) => ({
  name,
  ids: figures.map(({ id }) => id),
}));

export const LESSONS = COURSE.map(({ id }) => id);

/** The lessons by units. */
export const UNITS = COURSE_UNITS.map(({ title, figures }) => ({ title, ids: figures.map(({ id }) => id) }));

/** Opens a page of the figures, from another one without loading anew; "" is the index. */
export async function openFigure(page: Page, figure: string): Promise<void> {
  const place = LESSONS.includes(figure) ? "learn" : "figures";
  const fragment = `#${place}${figure === "" ? "" : `/${figure}`}`;
  if (page.url() === "about:blank") await page.goto(`./${fragment}`);
  else await page.evaluate((fragment) => location.assign(fragment), fragment);
  // The page before it is gone: its row says where we are.
  if (figure !== "") await page.locator(`nav [aria-current=page][href="${fragment}"]`).waitFor();
  await page.getByRole("heading", { level: 1 }).waitFor();
}

/** Opens the contents of the course. */
export async function openContents(page: Page): Promise<void> {
  if (page.url() === "about:blank") await page.goto("./#learn");
  else await page.evaluate(() => location.assign("#learn"));
  await page.getByRole("heading", { level: 1, name: "Learn" }).waitFor();
}

/** A prediction by keys alone. */
export async function guess(page: Page): Promise<void> {
  const question = page.getByRole("region", { name: "What do you think?" });
  const input = question.locator("fieldset input").first();
  await input.focus();
  // Where a slider stands at an end, one of the two moves it.
  const keys = (await input.getAttribute("type")) === "range" ? ["ArrowRight", "ArrowLeft"] : ["Space"];
  for (const key of keys) await page.keyboard.press(key);
}

export interface Look {
  /** Parts of the picture that hold something. */
  lit: number;
  colours: number;
  hash: number;
}

/** What is on a canvas. */
export function look(picture: Locator): Promise<Look> {
  return picture.evaluate((canvas) => {
    if (!(canvas instanceof HTMLCanvasElement)) throw new Error("not a canvas");
    const { width, height } = canvas;
    const image = canvas.getContext("2d")?.getImageData(0, 0, width, height);
    const pixels = new Uint32Array(image?.data.buffer ?? new ArrayBuffer(0));
    const held = pixels.filter((pixel) => pixel >>> 24 > 0);
    return {
      lit: held.length / Math.max(1, pixels.length),
      colours: new Set(held).size,
      hash: pixels.reduce((hash, pixel) => Math.imul(hash ^ pixel, 0x01000193), 0x811c9dc5),
    };
  });
}

/** Every picture of the page holds something, and there is one. */
export async function expectDrawn(page: Page): Promise<void> {
  await expect(page.getByRole("main").locator("canvas, svg").first()).toBeAttached();
  for (const picture of await page.getByRole("main").locator("canvas[role=img]").all()) {
    const name = (await picture.getAttribute("aria-label")) ?? "";
    await expect.poll(async () => (await look(picture)).lit, { message: name }).toBeGreaterThan(0.001);
  }
}

/** A canvas of the page holds a shape. Those of space have no name of their own: what is around them has. */
export async function expectShape(page: Page): Promise<void> {
  const most = () =>
    page.evaluate(() =>
      [...document.querySelectorAll("canvas")].reduce((most, canvas) => {
        const image = canvas.getContext("2d")?.getImageData(0, 0, canvas.width || 1, canvas.height || 1);
        const count = image ? image.data.filter((value, i) => i % 4 === 3 && value > 0).length : 0;
        return Math.max(most, count);
      }, 0),
    );
  await expect.poll(most).toBeGreaterThan(500);
}
