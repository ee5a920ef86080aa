import type { Locator, Page } from "@playwright/test";
import { expect } from "./fixture";

/** Opens a page of the figures, from another one without loading anew; "" is the index. */
export async function openFigure(page: Page, figure: string): Promise<void> {
  const fragment = `#figures${figure === "" ? "" : `/${figure}`}`;
  if (page.url() === "about:blank") await page.goto(`./${fragment}`);
  else await page.evaluate((fragment) => location.assign(fragment), fragment);
  // The page before it is gone: its row says where we are.
  if (figure !== "") await page.locator(`.figure-top [aria-current=page][href="${fragment}"]`).waitFor();
  await page.getByRole("heading", { level: 1 }).waitFor();
}

/** The addresses of a row of figures, as its first one lists them. */
export async function rowOf(page: Page, first: string): Promise<string[]> {
  await openFigure(page, first);
  return page
    .locator(".figure-top ol a")
    .evaluateAll((all) => all.map((a) => a.getAttribute("href")?.replace("#figures/", "") ?? ""));
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
