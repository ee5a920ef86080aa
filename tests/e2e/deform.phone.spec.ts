import { expectClean } from "./axe";
import { Finger } from "./finger";
import { expect, test } from "./fixture";

const GASKET = "v=1&a=gasket&b=gasket&path=straight&tool=deform";

test("a phone shows the picture with its time, and nothing scrolls sideways", async ({ studio, page }) => {
  await studio.open(GASKET);
  expect((await studio.look()).lit).toBeGreaterThan(1000);
  const { width, height } = page.viewportSize() ?? { width: 0, height: 0 };
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
  expect(
    await page.locator(".side").evaluate((side) => side.scrollWidth - side.clientWidth),
  ).toBeLessThanOrEqual(0);
  const stage = await page.locator(".stage").boundingBox();
  const time = await page.locator(".time").boundingBox();
  if (!stage || !time) throw new Error("no stage or no time strip");
  expect(stage.height).toBeGreaterThan(0.25 * height);
  expect(time.y).toBeGreaterThanOrEqual(stage.y + stage.height - 1);
  expect(time.y + time.height).toBeLessThanOrEqual(height);
  await expect(studio.time).toBeInViewport({ ratio: 1 });
  const strip = page.locator(".time .strip");
  expect(await strip.evaluate((e) => e.scrollWidth - e.clientWidth)).toBeLessThanOrEqual(0);
});

test("what a finger presses is large enough", async ({ studio, page }) => {
  await studio.open(GASKET);
  await studio.drawn();
  const small = () =>
    page.evaluate(() =>
      [
        ...document.querySelectorAll<HTMLElement>(
          "button, select, summary, .segment, .switch, [role=radiogroup] > label, a",
        ),
      ]
        .filter((element) => element.getClientRects().length > 0)
        .map((element) => ({ element, box: element.getBoundingClientRect() }))
        .filter(({ element, box }) => box.width < 44 || box.height < (element.matches(".segment") ? 38 : 44))
        .map(
          ({ element, box }) => `${element.ariaLabel ?? element.textContent}: ${box.width} x ${box.height}`,
        ),
    );
  expect(await small()).toEqual([]);
  await page.getByRole("radio", { name: "Grid" }).check();
  for (const summary of await page.locator("details.fold > summary").all()) await summary.tap();
  expect(await small()).toEqual([]);
});

test("a tap on a motion plays it, and a tap on a key frame goes there", async ({ studio, page }) => {
  await studio.open(GASKET);
  await studio.drawn();
  await page.getByRole("button", { name: "Sway" }).tap();
  await expect.poll(async () => (await studio.scene()).deform?.phase ?? 0).toBeGreaterThan(0.02);
  await page.getByRole("slider", { name: /^Keyframe 2 of 4/ }).tap();
  await expect(page.getByRole("button", { name: "Play", exact: true })).toBeVisible();
  expect((await studio.scene()).deform?.phase).toBe(0.25);
  await page.getByRole("button", { name: "Delete keyframe 2" }).tap();
  expect((await studio.scene()).deform?.keys).toHaveLength(3);
});

test("a key frame is dragged with a finger: one step of undo", async ({ studio, page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await studio.open(GASKET);
  await studio.drawn();
  await page.getByRole("button", { name: "Breathe" }).tap();
  const keys = async () => (await studio.scene()).deform?.keys.map(({ at }) => at);
  const box = await page.getByRole("slider", { name: /^Keyframe 4 of 4/ }).boundingBox();
  const track = await page.locator(".key-track").boundingBox();
  if (!box || !track) throw new Error("no key on the track");
  const from = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  const finger = await Finger.of(page);
  await finger.drag(from, { x: from.x + 0.1 * track.width, y: from.y });
  const moved = await keys();
  expect(moved?.slice(0, 3)).toEqual([0, 0.25, 0.5]);
  expect(moved?.[3]).toBeCloseTo(0.85, 1);
  expect((await studio.scene()).deform?.phase).toBe(moved?.[3]);
  // A tap right after a swift drag counts to the browser as stopping a fling, not as a click.
  await page.waitForTimeout(400);
  await page.getByRole("button", { name: "Undo", exact: true }).tap();
  await expect.poll(keys, { timeout: 5000 }).toEqual([0, 0.25, 0.5, 0.75]);
});

test("on its side, a phone still shows the picture and the time", async ({ studio, page }) => {
  await page.setViewportSize({ width: 844, height: 390 });
  await studio.open(GASKET);
  expect((await studio.look()).lit).toBeGreaterThan(1000);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(844);
  await expect(studio.time).toBeInViewport({ ratio: 1 });
});

test("axe finds nothing in the deformation tool on a phone", async ({ studio, page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await studio.open(GASKET);
  await studio.drawn();
  await expectClean(page);
  await page.getByRole("button", { name: "Wave" }).tap();
  for (const summary of await page.locator("details.fold > summary").all()) await summary.tap();
  await studio.drawn();
  await expectClean(page);
});
