import type { Locator } from "@playwright/test";
import { type Look, look, openFigure } from "./figure-pages";
import { expect, test } from "./fixture";

// Their pictures are computed without a graphics card, and cost by their pixels.
test.use({ viewport: { width: 640, height: 700 } });

/** The picture once it is drawn in full, and of what is asked for now. */
async function settled(picture: Locator): Promise<Look> {
  await expect(picture).toHaveAttribute("data-complete", "");
  return look(picture);
}

test("all are in the index, and lead on to each other", async ({ page }) => {
  await openFigure(page, "");
  const section = page.getByRole("region", { name: "Shapes that are bent at every scale" });
  await section.getByRole("link", { name: /A picture, shuffled/ }).click();
  await expect(page).toHaveTitle(/^Deformation, Figure 3/);
  await page.getByRole("navigation", { name: "Before and after" }).getByRole("link").last().click();
  await expect(page.getByRole("heading", { level: 1, name: "One pull" })).toBeFocused();
});

test("Figure 1 tells the code of the place that is pressed", async ({ page }) => {
  await openFigure(page, "d1");
  const square = page.getByRole("img", { name: /^\(c\)/ });
  await expect(square).toHaveAccessibleName(/has the code 23\.$/);
  await square.scrollIntoViewIfNeeded();
  const box = await square.boundingBox();
  if (!box) throw new Error("the square is not on the page");
  await page.mouse.click(box.x + 0.1 * box.width, box.y + 0.1 * box.height);
  await expect(square).toHaveAccessibleName(/has the code 33\.$/);
  await page.getByRole("slider", { name: "Letters" }).press("ArrowRight");
  await expect(square).toHaveAccessibleName(/has the code 333\.$/);
  await page.getByRole("slider", { name: "The point, across" }).press("End");
  await expect(page.getByRole("img", { name: /^\(a\)/ })).toHaveAccessibleName(/has the code 222\.$/);
});

test("Figure 2 tells all addresses of a place", async ({ page }) => {
  await openFigure(page, "d2");
  await expect(page.getByText("2 addresses in (a) and 4 addresses in (b)")).toBeVisible();
  await expect(page.getByText("122222…")).toBeVisible();
  const across = page.getByRole("slider", { name: "The ring, across" });
  await across.press("Home");
  await expect(page.getByText("one address in (a) and one address in (b)")).toBeVisible();
});

test("Figure 3 tells where a colour came from", async ({ page }) => {
  await openFigure(page, "d3");
  const image = (name: string) => page.getByRole("button", { name, exact: true });
  const canvas = (name: string) => image(name).locator("canvas");
  const plain = await look(canvas("kb 0, ke 0"));
  // Where the block has at most one letter, nothing is shuffled.
  for (const same of ["kb 0, ke 1", "kb 1, ke 1", "kb 2, ke 3"]) {
    expect((await look(canvas(same))).hash, same).toBe(plain.hash);
  }
  const different = ["kb 0, ke 2", "kb 0, ke 5", "kb 1, ke 5", "kb 0, all ke to 5 superposed"];
  const hashes = await Promise.all(different.map(async (name) => (await look(canvas(name))).hash));
  expect(new Set([plain.hash, ...hashes]).size).toBe(5);

  const source = page.getByRole("img", { name: /^Before the shuffle/ });
  await expect(source).toHaveAccessibleName("Before the shuffle: cell 21441 takes its colour from 41241.");
  await image("kb 0, ke 3").focus();
  await page.keyboard.press("ArrowRight");
  await expect(image("kb 0, ke 4")).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(source).toHaveAccessibleName("Before the shuffle: cell 21441 takes its colour from 44121.");
  await page.getByRole("radio", { name: /Gasket/ }).check();
  expect((await look(canvas("kb 0, ke 0"))).lit).toBeCloseTo((3 / 4) ** 7, 6);
});

test("Figure 4 lifts all eight gaskets, and slides from fractal to plain", async ({ page }) => {
  await openFigure(page, "d4");
  const picture = (name: RegExp) => page.locator("canvas[role=img]").and(page.getByRole("img", { name }));
  const [a, b, f, h] = [/plain, kb 9/, /fractal, kb 0/, /as A, kb 9/, /smooth to rough/].map(picture);
  const big = picture(/at locality/);
  if (!a || !b || !f || !h) throw new Error("a panel is missing");
  const lifted = { a: await settled(a), b: await settled(b), f: await settled(f), h: await settled(h) };
  for (const panel of Object.values(lifted)) {
    expect(panel.lit).toBeGreaterThan(0.02);
    expect(panel.colours).toBeGreaterThan(3);
  }
  expect(lifted.f.hash).toBe(lifted.a.hash);
  expect(new Set([lifted.a.hash, lifted.b.hash, lifted.h.hash]).size).toBe(3);

  const slide = page.getByRole("slider", { name: "Locality" });
  const fractal = await settled(big);
  await slide.press("End");
  await expect.poll(async () => (await look(big)).hash).not.toBe(fractal.hash);
  const plain = await settled(big);
  expect(plain.hash).not.toBe(fractal.hash);
  // One step below plain, and some more, not one pixel is another: only the way back shows that it is followed.
  await slide.press("ArrowLeft");
  await expect(big).toHaveAccessibleName(/at locality 8\.90 of 9/);
  await slide.press("Home");
  await expect.poll(async () => (await settled(big)).hash).toBe(fractal.hash);

  // At rest all are the same.
  await page.getByRole("radio", { name: "t₀" }).check();
  await expect.poll(async () => (await look(b)).hash).not.toBe(lifted.b.hash);
  expect((await settled(b)).hash).toBe((await settled(a)).hash);
  expect((await settled(h)).hash).toBe((await settled(a)).hash);
});

test("Figure 5 sways, and turns by choice", async ({ page }) => {
  await openFigure(page, "d5");
  const b = page.getByRole("img", { name: /^The fern fractal/ });
  const part = page.getByRole("img", { name: /^B-1: / });
  const [first, magnified] = [await settled(b), await settled(part)];
  expect(first.colours).toBeGreaterThan(3);
  expect(magnified.lit).toBeGreaterThan(0.02);
  await page.getByRole("radio", { name: "None" }).check();
  await expect.poll(async () => (await settled(b)).hash).not.toBe(first.hash);
  // It began as the paper words it.
  await page.getByRole("radio", { name: "Rotation" }).check();
  await expect.poll(async () => (await settled(b)).hash).toBe(first.hash);
  const addresses = await settled(page.getByRole("img", { name: /^The fern at rest: the part of map 1/ }));
  expect(addresses.colours).toBeGreaterThan(3);
  const time = page.getByRole("slider", { name: "Time t" });
  for (let i = 0; i < 5; i++) await time.press("PageUp");
  await expect.poll(async () => (await settled(b)).hash).not.toBe(first.hash);
  await expect.poll(async () => (await settled(part)).hash).not.toBe(magnified.hash);
});

test("Figure 6 has colours of its own, and draws them with it", async ({ page }) => {
  await openFigure(page, "d6");
  const b = page.getByRole("img", { name: /^The twin-dragon fractal/ });
  const drawn = await settled(b);
  // Blended and shuffled: far more colours than the maps have.
  expect(drawn.colours).toBeGreaterThan(100);
  expect(drawn.lit).toBeGreaterThan(0.1);
  await page.getByRole("slider", { name: "Time t" }).press("Home");
  await expect.poll(async () => (await settled(b)).hash).not.toBe(drawn.hash);
});
