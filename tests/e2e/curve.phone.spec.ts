import { expectClean } from "./axe";
import { Finger } from "./finger";
import { expect, test } from "./fixture";
import { Grid } from "./grid";

const LEAVES = "v=1&a=gasket&b=gasket&path=straight&curve-a=maple&curve-b=oak";

test("a phone shows the leaf with its time, and nothing scrolls sideways", async ({ studio, page }) => {
  await studio.open(`${LEAVES}&t=0.3`);
  const look = await studio.look();
  expect(look.lit).toBeGreaterThan(5000);
  expect(look.box[0]).toBeGreaterThan(0);
  expect(look.box[2]).toBeLessThan(look.width - 1);
  const { width } = page.viewportSize() ?? { width: 0 };
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
  expect(
    await page.locator(".side").evaluate((side) => side.scrollWidth - side.clientWidth),
  ).toBeLessThanOrEqual(0);
  const chip = await studio.verdict.boundingBox();
  const fit = await page.getByRole("button", { name: "Fit to the stage" }).boundingBox();
  if (!chip || !fit) throw new Error("nothing stands at the foot of the stage");
  expect(chip.x + chip.width).toBeLessThanOrEqual(fit.x);
  await expectClean(page);
});

test("what a finger presses is large enough", async ({ studio, page }) => {
  await studio.open(LEAVES);
  await studio.drawn();
  const small = await page.evaluate(() =>
    [...document.querySelectorAll<HTMLElement>("button, select, summary, .segment, .switch, a")]
      .filter((element) => element.getClientRects().length > 0)
      .map((element) => ({ element, box: element.getBoundingClientRect() }))
      .filter(({ element, box }) => {
        const high = element.matches(".segment") ? 38 : 44;
        // Frames of the film are as wide as there is room for.
        return box.height < high || (box.width < 44 && !element.matches(".frame"));
      })
      .map(({ element, box }) => `${element.ariaLabel ?? element.textContent}: ${box.width} x ${box.height}`),
  );
  expect(small).toEqual([]);
});

test("a curve is chosen by taps, and played", async ({ studio, page }) => {
  await studio.open("v=1&a=gasket&b=gasket&path=straight");
  await studio.drawn();
  await page.getByRole("button", { name: /^Shape B: / }).tap();
  await page.getByRole("region", { name: "Closed curves" }).getByRole("button", { name: /^Oak/ }).tap();
  await expect(page.getByRole("dialog")).toHaveCount(0);
  expect((await studio.scene()).curves).toMatchObject({
    a: { preset: "sugar-maple" },
    b: { preset: "white-oak" },
  });
  const before = await studio.look();
  await page.getByRole("button", { name: "Play", exact: true }).tap();
  await expect.poll(async () => (await studio.scene()).t).toBeGreaterThan(0.03);
  await page.getByRole("button", { name: "Pause" }).tap();
  expect((await studio.look()).hash).not.toBe(before.hash);
});

test("a finger pulls the grid and the leaf goes along", async ({ studio, page }) => {
  const grid = new Grid(page, studio);
  await grid.open(`${LEAVES}&tool=deform`);
  const rest = await studio.look();
  const from = await grid.place(1, 4);
  const finger = await Finger.of(page);
  await finger.drag(from, { x: from.x + 40, y: from.y + 30 });
  expect(await grid.count()).toBe(1);
  expect((await studio.look()).hash).not.toBe(rest.hash);
});
