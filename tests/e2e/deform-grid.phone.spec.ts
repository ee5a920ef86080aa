import { Finger } from "./finger";
import { expect, test } from "./fixture";
import { Grid } from "./grid";

test("a handle is dragged with a finger that is not quite on it", async ({ studio, page }) => {
  const grid = new Grid(page, studio);
  await grid.open("v=1&a=gasket&b=gasket&path=straight&tool=deform&mesh=4x4:0,0,1,1");
  const at = await grid.place(2, 2);
  const finger = await Finger.of(page);
  await finger.drag({ x: at.x + 14, y: at.y - 12 }, { x: at.x + 64, y: at.y - 42 });
  expect(await grid.count()).toBe(1);
  const now = await grid.place(2, 2);
  expect(now.x).toBeCloseTo(at.x + 50, 0);
  expect(now.y).toBeCloseTo(at.y - 30, 0);
  await page.getByRole("button", { name: "Undo", exact: true }).tap();
  expect(await grid.count()).toBe(0);
  await expect(page.getByRole("button", { name: "Undo", exact: true })).toBeDisabled();
});

test("one finger moves the picture, two enlarge it, even from a handle", async ({ studio, page }) => {
  const grid = new Grid(page, studio);
  await grid.open();
  const [low, high] = [await grid.place(2, 2), await grid.place(3, 3)];
  const finger = await Finger.of(page);
  const between = { x: (low.x + high.x) / 2, y: (low.y + high.y) / 2 };
  await finger.drag(between, { x: between.x + 30, y: between.y + 20 });
  const moved = await grid.place(2, 2);
  expect(moved.x).toBeCloseTo(low.x + 30, 0);
  await finger.join(moved, 60, 120);
  await expect(page.getByTestId("zoom")).toHaveText("×2.0");
  // The finger on the handle has let go of it: nothing is bent, and there is nothing to undo.
  expect(await grid.count()).toBe(0);
  await expect(page.getByRole("button", { name: "Undo", exact: true })).toBeDisabled();
  const near = await grid.place(2, 2);
  expect(near.x).toBeCloseTo(moved.x, 0);
});

test("a drag that has begun is taken back when a second finger comes", async ({ studio, page }) => {
  const grid = new Grid(page, studio);
  await grid.open();
  const at = await grid.place(3, 2);
  const finger = await Finger.of(page);
  await finger.dragThenJoin(at, { x: at.x, y: at.y - 40 }, 60, 90);
  expect(await grid.count()).toBe(0);
  await expect(page.getByTestId("zoom")).toHaveText("×1.5");
});

test("hands without modifier keys pull and choose", async ({ studio, page }) => {
  const grid = new Grid(page, studio);
  await grid.open();
  const [low, high] = [await grid.place(2, 2), await grid.place(3, 3)];
  const finger = await Finger.of(page);
  await page.getByRole("radio", { name: "Pull" }).check();
  const at = { x: low.x + 0.45 * (high.x - low.x), y: low.y + 0.45 * (high.y - low.y) };
  await finger.drag(at, { x: at.x, y: at.y - 40 });
  expect(await grid.count()).toBe(16);
  await page.getByRole("button", { name: "Undo", exact: true }).tap();
  await page.getByRole("radio", { name: "Select" }).check();
  await finger.tap(low);
  await finger.tap(high);
  expect(await grid.chosen()).toBe(2);
  await finger.tap(low);
  expect(await grid.chosen()).toBe(1);
  await finger.drag({ x: low.x - 30, y: low.y + 30 }, { x: high.x + 30, y: high.y - 30 });
  expect(await grid.chosen()).toBe(4);
  await finger.drag(low, { x: low.x + 20, y: low.y });
  expect(await grid.count()).toBe(4);
});
