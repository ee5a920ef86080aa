import { Finger } from "./finger";
import { expect, test } from "./fixture";

test("a waypoint is dragged with a finger: one step of undo", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&path=drawn:0.2,0.8&t=0.5");
  await studio.square.evaluate((square) => square.scrollIntoView({ block: "center" }));
  const before = await studio.look();
  const finger = await Finger.of(page);
  await finger.drag(await studio.place(0.2, 0.8), await studio.place(0.6, 0.3));
  const [point] = (await studio.scene()).path.points;
  expect(point?.[0]).toBeCloseTo(0.6, 1);
  expect(point?.[1]).toBeCloseTo(0.3, 1);
  expect((await studio.look()).hash).not.toBe(before.hash);
  await page.getByRole("button", { name: "Undo", exact: true }).tap();
  expect((await studio.scene()).path.points).toEqual([[0.2, 0.8]]);
  await expect(page.getByRole("button", { name: "Undo", exact: true })).toBeDisabled();
});

test("waypoints are added and taken away with a finger", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&path=straight&t=0.5");
  await page.getByRole("button", { name: "Add waypoint" }).tap();
  expect((await studio.scene()).path).toEqual({ kind: "drawn", points: [[0.5, 0.5]] });
  await page.getByRole("button", { name: "Remove this waypoint" }).tap();
  expect((await studio.scene()).path.points).toEqual([]);
});

test("the picture is pinched and moved", async ({ studio, page }) => {
  await studio.open("a=gasket&b=gasket");
  const before = await studio.look();
  const box = await page.getByRole("application", { name: /^The attractor/ }).boundingBox();
  if (!box) throw new Error("no stage");
  const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  const finger = await Finger.of(page);
  await finger.pinch(middle, 60, 180);
  await expect(page.getByTestId("zoom")).toHaveText("×3.0");
  const near = await studio.look();
  expect(near.hash).not.toBe(before.hash);
  await finger.drag(middle, { x: middle.x + 40, y: middle.y + 30 });
  expect((await studio.look()).hash).not.toBe(near.hash);
  await expect(page.getByTestId("zoom")).toHaveText("×3.0");
  await page.getByRole("button", { name: "Fit to the stage" }).tap();
  expect(await studio.look()).toEqual(before);
});

test("a parallelogram is dragged with a finger", async ({ studio, page }) => {
  await studio.open("a=gasket&b=gasket&path=straight");
  await page.getByRole("button", { name: "Edit the maps of A" }).tap();
  await studio.idle();
  const { maps } = (await studio.scene()).a;
  const grip = await page.getByRole("button", { name: /^Map 1, first side/ }).boundingBox();
  if (!grip) throw new Error("no grip");
  const from = { x: grip.x + grip.width / 2, y: grip.y + grip.height / 2 };
  await (await Finger.of(page)).drag(from, { x: from.x - 30, y: from.y - 10 });
  const after = (await studio.scene()).a.maps;
  expect(after[0]?.[0]).toBeLessThan(maps[0]?.[0] ?? 0);
  expect(after.slice(1)).toEqual(maps.slice(1));
});

test("two fingers on the outlines of maps pinch the picture, and change no map", async ({ studio, page }) => {
  await studio.open("a=gasket&b=gasket&path=straight");
  await page.getByRole("button", { name: "Edit the maps of A" }).tap();
  await studio.idle();
  const before = (await studio.scene()).a;
  const box = await page.getByRole("application", { name: /^The attractor/ }).boundingBox();
  if (!box) throw new Error("no stage");
  const middle = { x: box.x + box.width / 2, y: box.y + box.height * 0.6 };
  const finger = await Finger.of(page);
  // Both at once, one after the other has begun to drag, and one beside all maps first.
  await finger.pinch(middle, 60, 120);
  await expect(page.getByTestId("zoom")).toHaveText("×2.0");
  await finger.dragThenJoin(middle, { x: middle.x + 20, y: middle.y }, 30, 60);
  await finger.join({ x: box.x + 12, y: middle.y }, middle.x - box.x, (middle.x - box.x) / 2);
  expect((await studio.scene()).a).toEqual(before);
  await expect(page.getByRole("button", { name: "Undo", exact: true })).toBeDisabled();
  expect(await page.evaluate(() => visualViewport?.scale)).toBe(1);
});

test("time is scrubbed with a finger", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&path=straight");
  const box = await studio.time.boundingBox();
  if (!box) throw new Error("no slider");
  const y = box.y + box.height / 2;
  await (await Finger.of(page)).drag({ x: box.x + 10, y }, { x: box.x + box.width / 2, y });
  expect((await studio.scene()).t).toBeCloseTo(0.5, 1);
});

test("a swipe that begins on a slider of a lesson scrolls, and a finger that goes sideways sets it", async ({
  page,
}) => {
  await page.goto("./#learn/e14");
  const slider = page.locator("main input[type=range]").first();
  await slider.evaluate((element) => element.scrollIntoView({ block: "center" }));
  const box = await slider.boundingBox();
  if (!box) throw new Error("no slider");
  const from = { x: box.x + box.width * 0.2, y: box.y + box.height / 2 };
  const finger = await Finger.of(page);
  const before = await slider.inputValue();
  await finger.drag(from, { x: from.x + 4, y: from.y - 200 }, 12);
  await expect.poll(async () => (await slider.boundingBox())?.y).toBeLessThan(box.y - 50);
  expect(await slider.inputValue()).toBe(before);
  await slider.evaluate((element) => element.scrollIntoView({ block: "center" }));
  await finger.drag(from, { x: from.x + 60, y: from.y });
  const dragged = await slider.inputValue();
  expect(dragged).not.toBe(before);
  await finger.tap(from);
  await expect.poll(() => slider.inputValue()).not.toBe(dragged);
});
