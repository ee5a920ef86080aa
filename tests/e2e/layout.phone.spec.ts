import { expectClean } from "./axe";
import { expect, test } from "./fixture";

test("a phone shows the picture with its time, and nothing scrolls sideways", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&path=straight&t=0.5");
  const look = await studio.look();
  expect(look.lit).toBeGreaterThan(1000);
  const { width, height } = page.viewportSize() ?? { width: 0, height: 0 };
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
  expect(
    await page.locator(".side").evaluate((side) => side.scrollWidth - side.clientWidth),
  ).toBeLessThanOrEqual(0);
  const stage = await page.locator(".stage").boundingBox();
  const time = await page.locator(".time").boundingBox();
  if (!stage || !time) throw new Error("no stage or no time strip");
  expect(stage.height).toBeGreaterThan(0.25 * height);
  expect(stage.y).toBeGreaterThanOrEqual(0);
  expect(time.y).toBeGreaterThanOrEqual(stage.y + stage.height - 1);
  expect(time.y + time.height).toBeLessThanOrEqual(height);
  await expect(studio.verdict).toBeInViewport({ ratio: 1 });
  await expect(studio.time).toBeInViewport({ ratio: 1 });
});

test("the locus is wholly visible when scrolled to, with the picture above it", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&path=drawn:0.2,0.8");
  await studio.square.evaluate((square) => square.scrollIntoView({ block: "center" }));
  await expect(studio.square).toBeInViewport({ ratio: 0.99 });
  const box = await studio.square.boundingBox();
  expect(box?.width).toBeCloseTo(box?.height ?? 0, 0);
  const time = await page.locator(".time").boundingBox();
  expect(box?.y).toBeGreaterThanOrEqual((time?.y ?? 0) + (time?.height ?? 0) - 1);
  await expect(page.locator(".stage canvas").first()).toBeInViewport();
});

test("what a finger presses is large enough", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&path=drawn:0.2,0.8");
  await studio.idle();
  const small = () =>
    page.evaluate(() =>
      [...document.querySelectorAll<HTMLElement>("button, select, summary, .segment, .switch, a")]
        // Frames of the film are as wide as the film allows; a segment has the edge of its group around it.
        .filter((element) => element.getClientRects().length > 0 && !element.matches(".frame"))
        .map((element) => ({ element, box: element.getBoundingClientRect() }))
        .filter(({ element, box }) => box.width < 44 || box.height < (element.matches(".segment") ? 38 : 44))
        .map(
          ({ element, box }) => `${element.ariaLabel ?? element.textContent}: ${box.width} x ${box.height}`,
        ),
    );
  expect(await small()).toEqual([]);
  await page.getByRole("button", { name: "Edit the maps of A" }).tap();
  expect(await small()).toEqual([]);
});

test("on its side, a phone still shows the picture and the time", async ({ studio, page }) => {
  await page.setViewportSize({ width: 844, height: 390 });
  await studio.open("a=dragon-3&b=gasket&path=straight&t=0.5");
  expect((await studio.look()).lit).toBeGreaterThan(1000);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(844);
  await expect(page.locator(".stage canvas").first()).toBeInViewport({ ratio: 0.99 });
  await expect(studio.time).toBeInViewport({ ratio: 1 });
  await studio.square.evaluate((square) => square.scrollIntoView({ block: "center" }));
  await expect(studio.square).toBeInViewport();
});

test("axe finds nothing on a phone", async ({ studio, page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await studio.open("a=dragon-3&b=gasket&path=drawn:0.2,0.8&t=0.5");
  await studio.idle();
  await expectClean(page);
  await page.getByRole("button", { name: /^Shape A: / }).tap();
  await expectClean(page);
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "Edit the maps of A" }).tap();
  await expectClean(page);
});

test("words at twice their size push nothing out of the window", async ({ studio, page }) => {
  for (const [width, height] of [
    [390, 844],
    [1280, 800],
  ] as const) {
    await page.setViewportSize({ width, height });
    await studio.open("a=dragon-3&b=gasket&path=straight&t=0.5");
    // By script: the policy of the built pages lets no other style in.
    await page.evaluate(() => {
      document.documentElement.style.fontSize = "200%";
    });
    await expect(page.getByRole("button", { name: "Share", exact: true })).toBeInViewport({ ratio: 1 });
    const out = () =>
      page.evaluate(() =>
        [...document.querySelectorAll<HTMLElement>(".header :is(a, button, select), .side *, .readout *")]
          .filter((e) => e.getClientRects().length > 0 && getComputedStyle(e).position === "static")
          .map((e) => ({ e, edge: e.closest(".side, .stage")?.getBoundingClientRect().right ?? innerWidth }))
          .filter(({ e, edge }) => !e.closest("svg") && e.getBoundingClientRect().right > edge + 1)
          .map(({ e }) => `${e.className} ${e.textContent}`),
      );
    await expect.poll(out, { message: `${width} x ${height}` }).toEqual([]);
  }
});
