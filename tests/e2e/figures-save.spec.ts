import { readFile } from "node:fs/promises";
import type { Page } from "@playwright/test";
import { expectDrawn, openFigure } from "./figure-pages";
import { expect, test } from "./fixture";

async function saved(page: Page, what: string): Promise<{ name: string; bytes: Buffer }> {
  await page.getByRole("button", { name: "Save the picture" }).click();
  const coming = page.waitForEvent("download");
  await page.getByRole("menuitem", { name: what, exact: true }).click();
  const download = await coming;
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

/** What a reader of the file finds in it, and what is drawn in each of its quarters. */
function read(page: Page, text: string) {
  return page.evaluate(async (text) => {
    const file = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
    const image = new Image();
    image.src = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
    await image.decode();
    const [width, height] = [Math.floor(image.width / 2), Math.floor(image.height / 2)];
    const canvas = document.createElement("canvas");
    const pen = canvas.getContext("2d");
    if (!pen) throw new Error("no canvas");
    canvas.width = 2 * width;
    canvas.height = 2 * height;
    pen.drawImage(image, 0, 0);
    const inked = (x: number, y: number) => {
      const pixels = new Uint32Array(pen.getImageData(x, y, width, height).data.buffer);
      return pixels.filter((pixel) => pixel !== 0xffff_ffff && pixel >>> 24 > 0).length / pixels.length;
    };
    return {
      root: file.localName,
      names: [...new Set([...file.querySelectorAll("*")].map(({ localName }) => localName))],
      families: [...new Set([...file.querySelectorAll("text")].map((it) => it.getAttribute("font-family")))],
      words: [...file.querySelectorAll("text")].map((it) => it.textContent),
      pictures: [...file.querySelectorAll("image")].length,
      inked: [inked(0, 0), inked(width, 0), inked(0, height), inked(width, height)],
    };
  }, text);
}

/** Of SVG 1.1, and what programs for drawing know of it. */
const PLAIN =
  /^(svg|title|desc|g|defs|rect|line|circle|ellipse|path|polyline|polygon|text|tspan|image|clipPath|pattern|marker|mask|linearGradient|stop)$/;

test("a figure is saved as it is seen, without what moves it, for programs that know no style sheets", async ({
  page,
}) => {
  await openFigure(page, "1");
  await page.getByRole("button", { name: "Next iteration" }).click();
  const { name, bytes } = await saved(page, "Save as SVG");
  expect(name).toBe("frond-figure-1.svg");
  const text = bytes.toString();
  expect(text).not.toMatch(/var\(|foreignObject|class=|<style|href="(?!data:)/);
  const drawing = await read(page, text);
  expect(drawing.root).toBe("svg");
  expect(drawing.names.filter((name) => !PLAIN.test(name))).toEqual([]);
  expect(drawing.families).toEqual(["sans-serif"]);
  // The verdict in one line, its words apart.
  expect(drawing.words.find((words) => /proved/.test(words))).toMatch(
    /^[A-Z]\w+( \w+)*,? proved.* after \d+ of at most 10$|^Nothing proved yet after \d+ of at most 10$/,
  );
  expect(drawing.words).toContain("the dust itself");
  expect(drawing.words.join("\n")).not.toContain("Next iteration");
});

test("all squares of a figure are in its file, and the page is as it was", async ({ page }) => {
  await openFigure(page, "d1");
  const live = page.getByTestId("live").first();
  const before = await live.boundingBox();
  const drawing = await read(page, (await saved(page, "Save as SVG")).bytes.toString());
  expect(drawing.words.filter((words) => /^[1-4]{2}$/.test(words)).length).toBeGreaterThanOrEqual(16);
  for (const share of drawing.inked) expect(share).toBeGreaterThan(0.02);
  expect(await live.boundingBox()).toEqual(before);
});

test("pictures go into the file, in light colours on white from a dark page too, or on nothing", async ({
  page,
}) => {
  await page.emulateMedia({ colorScheme: "dark", reducedMotion: "reduce" });
  await openFigure(page, "3");
  await expectDrawn(page);
  const { name, bytes } = await saved(page, "Save as PNG");
  expect(name).toBe("frond-figures-3-and-4.png");
  const corner = (bytes: Buffer) =>
    page.evaluate(async (base64) => {
      const image = new Image();
      image.src = `data:image/png;base64,${base64}`;
      await image.decode();
      const canvas = document.createElement("canvas");
      const pen = canvas.getContext("2d");
      pen?.drawImage(image, 0, 0);
      return [image.width, ...(pen?.getImageData(1, 1, 1, 1).data ?? [])];
    }, bytes.toString("base64"));
  const [width = 0, ...pixel] = await corner(bytes);
  expect(width).toBeGreaterThan(1200);
  expect(pixel).toEqual([255, 255, 255, 255]);
  expect((await corner((await saved(page, "Save as PNG, background clear")).bytes)).slice(1)).toEqual([
    0, 0, 0, 0,
  ]);
  const drawing = await read(page, (await saved(page, "Save as SVG")).bytes.toString());
  expect(drawing.pictures).toBeGreaterThanOrEqual(2);
  // Dark again, as it was chosen.
  await expect.poll(() => page.evaluate(() => document.documentElement.dataset["theme"])).toBeUndefined();
});

test("what is drawn in the ink of a dark page is printed in dark ink", async ({ page }) => {
  await page.emulateMedia({ colorScheme: "dark", reducedMotion: "reduce" });
  await openFigure(page, "2");
  await expectDrawn(page);
  const shade = () => page.locator("main canvas").first().evaluate(look);
  const dark = await shade();
  const printed = await page.evaluate(() => dispatchEvent(new Event("beforeprint"))).then(shade);
  expect(printed).not.toBe(dark);
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  await expect.poll(shade).toBe(dark);
});

function look(canvas: HTMLElement | SVGElement): string {
  return canvas instanceof HTMLCanvasElement ? canvas.toDataURL() : "";
}
