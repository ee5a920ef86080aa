import { expect, test } from "./fixture";

test.use({ alone: true, expected: /context.*lost|device.*lost|CONTEXT_LOST|destroyed/i });

test("a lost device costs nothing but a notice", { tag: "@webgpu" }, async ({ studio, page }, info) => {
  await studio.open("a=dragon-3&b=gasket&path=straight&t=0.7");
  const before = await studio.look();
  await page.evaluate(() => window.frond?.forceLoss());
  await expect
    .poll(() => studio.said())
    .toEqual([expect.stringContaining("The graphics card stopped responding")]);
  expect(await studio.look()).toEqual(before);
  expect(await page.evaluate(() => window.frond?.backend())).toBe(info.project.name);
  await expect(studio.alerts).toHaveCount(0);
  // It draws on as before.
  await studio.time.press("End");
  expect((await studio.look()).hash).not.toBe(before.hash);
  expect(await studio.likeness()).toBeGreaterThanOrEqual(0.995);
});

test("a device that is lost again and again is given up, and the picture stays", { tag: "@webgpu" }, async ({
  studio,
  page,
}) => {
  await studio.open("a=dragon-3&b=gasket&path=straight&t=0.7");
  const before = await studio.look();
  const canvas = page.locator(".picture canvas");
  for (let losses = 0; losses < 3; losses++) {
    await canvas.evaluate((old) => old.setAttribute("data-old", ""));
    await page.evaluate(() => window.frond?.forceLoss());
    await expect(page.locator("canvas[data-old]")).toHaveCount(0);
    await studio.drawn();
  }
  await expect.poll(() => page.evaluate(() => window.frond?.backend())).toBe("canvas");
  const after = await studio.look();
  expect(Math.abs(after.lit - before.lit)).toBeLessThan(0.005 * before.lit);
  expect(
    await page.getByRole("status").filter({ hasText: "stopped responding" }).count(),
  ).toBeLessThanOrEqual(1);
});

test("without any graphics device there is a picture too", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&path=straight&t=0.7", "?backend=canvas");
  const look = await studio.look();
  expect(await page.evaluate(() => window.frond?.backend())).toBe("canvas");
  expect(look.lit).toBeGreaterThan(1000);
});

test.describe("a renderer that cannot be loaded", () => {
  test.use({ expected: /frond-web(gl2|gpu)|Failed to load resource/ });

  test("is done without", async ({ studio, page }) => {
    await page.route(/frond-web(gl2|gpu)/, (route) => route.abort());
    await studio.open("a=gasket&b=gasket");
    await expect
      .poll(() => studio.said())
      .toEqual([expect.stringContaining("the processor draws the picture")]);
    expect((await studio.look()).lit).toBeGreaterThan(1000);
    expect(await page.evaluate(() => window.frond?.backend())).toBe("canvas");
  });
});
