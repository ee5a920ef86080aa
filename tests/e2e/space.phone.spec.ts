import { expectClean } from "./axe";
import { Finger } from "./finger";
import { expect, test } from "./fixture";

test("a phone shows space with its time, and a finger looks around and turns", async ({ studio, page }) => {
  await studio.open("tool=space&space=o:tetrahedron");
  const status = page.getByTestId("space-status");
  await expect(status).toHaveText("Complete picture", { timeout: 120_000 });
  const first = await studio.look();
  expect(first.lit).toBeGreaterThan(10_000);
  const { width, height } = page.viewportSize() ?? { width: 0, height: 0 };
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
  const box = await page.getByTestId("space-stage").boundingBox();
  const time = await page.locator(".time").boundingBox();
  if (!box || !time) throw new Error("no stage or no time strip");
  expect(box.height).toBeGreaterThan(0.25 * height);
  expect(time.y + time.height).toBeLessThanOrEqual(height);
  await expect(studio.time).toBeInViewport({ ratio: 1 });
  await expectClean(page);

  const finger = await Finger.of(page);
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const packed = async () => (await studio.scene()).space?.packed;
  const before = await packed();
  await finger.drag({ x, y }, { x: x + 80, y: y + 10 });
  expect(await packed()).toBe(before);
  expect((await studio.scene()).space?.view).toBeDefined();
  await page.getByRole("radio", { name: "Rotate", exact: true }).first().check({ force: true });
  await finger.drag({ x, y }, { x: x + 80, y: y + 10 });
  await expect.poll(packed).toContain("~m");
});

test("what a finger presses in space is large enough", async ({ studio, page }) => {
  await studio.open("tool=space");
  await studio.drawn();
  const small = await page.evaluate(() =>
    [...document.querySelectorAll<HTMLElement>("button, select, summary, .segment, .switch, a")]
      .filter((element) => element.getClientRects().length > 0)
      .map((element) => ({ element, box: element.getBoundingClientRect() }))
      .filter(({ element, box }) => box.height < (element.matches(".segment") ? 38 : 44) || box.width < 40)
      .map(({ element, box }) => `${element.ariaLabel ?? element.textContent}: ${box.width} x ${box.height}`),
  );
  expect(small).toEqual([]);
});
