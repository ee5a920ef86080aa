import { expectClean } from "./axe";
import { expect, test } from "./fixture";
import { Grid } from "./grid";

test("a handle is dragged: one step of undo", async ({ studio, page }) => {
  const grid = new Grid(page, studio);
  await grid.open();
  expect((await studio.scene()).deform).toBeUndefined();
  const at = await grid.place(2, 3);
  await page.mouse.move(at.x + 4, at.y - 3);
  await page.mouse.down();
  await page.mouse.move(at.x + 64, at.y - 43, { steps: 5 });
  // While it is held, it is under the pointer, as far from it as where it was taken hold of.
  const now = await grid.place(2, 3);
  expect(Math.abs(now.x - at.x - 60)).toBeLessThan(2);
  expect(Math.abs(now.y - at.y + 40)).toBeLessThan(2);
  await page.mouse.up();
  const [dx, dy] = await grid.moved(2, 3);
  expect(dx).toBeGreaterThan(0);
  expect((dy ?? 0) / (dx ?? 1)).toBeCloseTo(40 / 60, 1);
  expect(await grid.count()).toBe(1);
  await expect(grid.handle(2, 3)).toHaveAccessibleName(/: moved 0\.\d+ right, 0\.\d+ up$/);
  // The keys go on where the pointer was.
  await expect(grid.handle(2, 3)).toBeFocused();
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  expect(await grid.count()).toBe(0);
  await expect(page.getByRole("button", { name: "Undo", exact: true })).toBeDisabled();
  await expect(grid.handle(2, 3)).toHaveAccessibleName(/: at rest$/);
});

test("Escape takes a drag back while it lasts, and lets go of what is chosen after it", async ({
  studio,
  page,
}) => {
  const grid = new Grid(page, studio);
  await grid.open();
  const at = await grid.place(3, 2);
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x + 50, at.y, { steps: 4 });
  expect(await grid.count()).toBe(1);
  await page.keyboard.press("Escape");
  await page.mouse.move(at.x + 90, at.y);
  await page.mouse.up();
  expect(await grid.count()).toBe(0);
  await grid.drag(at, 30, 0);
  expect(await grid.chosen()).toBe(1);
  await page.keyboard.press("Escape");
  expect(await grid.chosen()).toBe(0);
  expect(await grid.count()).toBe(1);
});

test("several handles move together", async ({ studio, page }) => {
  const grid = new Grid(page, studio);
  await grid.open();
  await test.step("added one by one", async () => {
    const [first, second] = [await grid.place(1, 1), await grid.place(4, 1)];
    await page.mouse.click(first.x, first.y);
    await page.keyboard.down("Shift");
    await page.mouse.click(second.x, second.y);
    await page.keyboard.up("Shift");
    expect(await grid.chosen()).toBe(2);
    await grid.drag(first, 0, -30);
    expect(await grid.moved(4, 1)).toEqual(await grid.moved(1, 1));
    expect(await grid.count()).toBe(2);
  });
  await test.step("one of them alone again, by a press without a drag", async () => {
    const at = await grid.place(4, 1);
    await page.mouse.click(at.x, at.y);
    expect(await grid.chosen()).toBe(1);
  });
  await test.step("framed", async () => {
    const [low, high] = [await grid.place(2, 2), await grid.place(3, 3)];
    await page.keyboard.down("Shift");
    await grid.drag({ x: low.x - 30, y: low.y + 30 }, high.x - low.x + 60, high.y - low.y - 60);
    await page.keyboard.up("Shift");
    // The one that was chosen, and the four inside.
    expect(await grid.chosen()).toBe(5);
    await page.keyboard.press("Escape");
    await page.getByRole("radio", { name: "Select" }).check();
    await grid.drag({ x: low.x - 30, y: low.y + 30 }, high.x - low.x + 60, high.y - low.y - 60);
    expect(await grid.chosen()).toBe(4);
    await page.getByRole("radio", { name: "Move" }).check();
    await grid.drag(low, 20, 0);
    expect(await grid.count()).toBe(6);
    await page.getByRole("button", { name: "Undo", exact: true }).click();
    expect(await grid.count()).toBe(2);
  });
  await test.step("a press on the picture lets go", async () => {
    const at = await grid.place(4, 4);
    await page.mouse.click(at.x + 60, at.y);
    expect(await grid.chosen()).toBe(0);
  });
});

test("the mesh is one stop of Tab, and keys do all that a hand does", async ({ studio, page }) => {
  const grid = new Grid(page, studio);
  await grid.open();
  await expect(grid.handles.and(page.locator("[tabindex='0']"))).toHaveCount(1);
  await grid.handle(1, 1).focus();
  await page.keyboard.press("]");
  await expect(grid.handle(2, 1)).toBeFocused();
  await page.keyboard.press("PageDown");
  await expect(grid.handle(3, 1)).toBeFocused();
  await page.keyboard.press("[");
  await page.keyboard.press("Control+ArrowUp");
  await expect(grid.handle(2, 2)).toBeFocused();
  await expect(grid.handle(2, 2)).toHaveAttribute("tabindex", "0");

  const t = (await studio.scene()).t;
  await page.keyboard.press("ArrowRight");
  const { deform } = await studio.scene();
  const [x0, y0, x1, y1] = deform?.box ?? [0, 0, 0, 0];
  const size = Math.max(x1 - x0, y1 - y0);
  expect((await grid.moved(2, 2))[0]).toBeCloseTo(0.01 * size, 3);
  await page.keyboard.press("Shift+ArrowUp");
  expect((await grid.moved(2, 2))[1]).toBeCloseTo(0.1 * size, 3);
  await page.keyboard.press("Alt+ArrowDown");
  expect((await grid.moved(2, 2))[1]).toBeCloseTo(0.099 * size, 3);
  await expect(page.locator("p[aria-live=polite]")).toHaveText(
    /^Column 2, row 2: moved 0\.\d+ right, 0\.\d+ up$/,
  );
  // Elsewhere on the page these keys mean the time.
  expect((await studio.scene()).t).toBe(t);

  await page.keyboard.press("Control+A");
  expect(await grid.chosen()).toBe(16);
  await page.keyboard.press("ArrowLeft");
  expect(await grid.count()).toBe(16);
  await page.keyboard.press("Control+z");
  expect(await grid.count()).toBe(1);
  await page.keyboard.press("Escape");
  expect(await grid.chosen()).toBe(0);
  await page.keyboard.press("Delete");
  expect(await grid.count()).toBe(0);
  await page.keyboard.press("Control+z");
  expect(await grid.count()).toBe(1);
});

test("what is moved is mirrored", async ({ studio, page }) => {
  const grid = new Grid(page, studio);
  await grid.open();
  await page.getByRole("radio", { name: "Left/right" }).check();
  await grid.drag(await grid.place(1, 3), -30, -20);
  const [dx = 0, dy = 0] = await grid.moved(1, 3);
  expect(dx).toBeLessThan(0);
  expect(await grid.moved(4, 3)).toEqual([-dx, dy]);
  expect(await grid.count()).toBe(2);
  await page.getByRole("radio", { name: "Point" }).check();
  await grid.handle(2, 2).focus();
  await page.keyboard.press("ArrowUp");
  const [, up = 0] = await grid.moved(2, 2);
  expect(up).toBeGreaterThan(0);
  expect(await grid.moved(3, 3)).toEqual([0, -up]);
  // It mirrors what is taken back, too.
  await page.keyboard.press("Delete");
  expect(await grid.count()).toBe(2);
  await page.getByRole("button", { name: "Reset all" }).click();
  expect(await grid.count()).toBe(0);
  await expect(page.getByRole("button", { name: "Reset all" })).toBeDisabled();
});

test("what is chosen is moved by numbers", async ({ studio, page }) => {
  const grid = new Grid(page, studio);
  await grid.open();
  const right = page.getByRole("spinbutton", { name: "Moved right" });
  await expect(right).toHaveCount(0);
  const [first, second] = [await grid.place(2, 2), await grid.place(3, 2)];
  await page.mouse.click(first.x, first.y);
  await page.keyboard.down("Shift");
  await page.mouse.click(second.x, second.y);
  await page.keyboard.up("Shift");
  await right.fill("1/8");
  await right.press("Enter");
  await expect(right).toHaveAttribute("data-settled", "true");
  expect(await grid.moved(2, 2)).toEqual([0.125, 0]);
  expect(await grid.moved(3, 2)).toEqual([0.125, 0]);
  await right.fill("1e300");
  await right.press("Enter");
  await expect(page.getByText(/^Enter at most /)).toBeVisible();
  expect(await grid.moved(3, 2)).toEqual([0.125, 0]);
  await right.press("Escape");
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  expect(await grid.count()).toBe(0);
});

test("between two key frames a drag makes a third", async ({ studio, page }) => {
  const grid = new Grid(page, studio);
  await grid.open(
    "v=1&a=gasket&b=gasket&path=straight&tool=deform&mesh=4x4:0,0,1,1&keys=0:;0.5:6,0.2,0&phase=0.25",
  );
  const at = await grid.place(2, 2);
  await grid.drag(at, 0, -30);
  const keys = async () => (await studio.scene()).deform?.keys.map(({ at, moves }) => [at, moves[10]]);
  const [first, made, last] = (await keys()) ?? [];
  expect([first, last]).toEqual([
    [0, 0],
    [0.5, 0.2],
  ]);
  expect(made?.[0]).toBe(0.25);
  expect(made?.[1]).toBeCloseTo(0.1, 1);
  // There is one now: it changes.
  await grid.drag(await grid.place(2, 2), 30, 0);
  expect(await keys()).toHaveLength(3);
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  expect(await keys()).toHaveLength(2);
});

test("the grid has more handles, or fewer, and none when it is not shown", async ({ studio, page }) => {
  const grid = new Grid(page, studio);
  await grid.open();
  await grid.drag(await grid.place(2, 3), 30, -50);
  const columns = page.getByRole("spinbutton", { name: "Columns" });
  await columns.fill("6");
  await columns.press("Enter");
  await expect(grid.handles).toHaveCount(24);
  expect((await studio.scene()).deform).toMatchObject({ columns: 6, rows: 4 });
  for (const wrong of ["17", "1", "2.5", "many"]) {
    await columns.fill(wrong);
    await columns.press("Enter");
    await expect(columns).toHaveAttribute("aria-invalid", "true");
    expect((await studio.scene()).deform).toMatchObject({ columns: 6, rows: 4 });
  }
  await columns.press("Escape");
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  expect((await studio.scene()).deform).toMatchObject({ columns: 4, rows: 4 });
  expect(await grid.count()).toBe(1);
  const at = await grid.place(2, 3);
  await page.getByRole("switch", { name: "Show grid" }).uncheck();
  await expect(grid.handles).toHaveCount(0);
  // The picture has the whole stage to itself.
  const view = (await studio.scene()).view;
  await grid.drag(at, 30, 30);
  expect(await grid.count()).toBe(1);
  expect((await studio.scene()).view).not.toEqual(view);
});

test("chosen handles are put back by the button", async ({ studio, page }) => {
  const grid = new Grid(page, studio);
  await grid.open();
  await grid.drag(await grid.place(2, 2), 40, 40);
  await grid.drag(await grid.place(3, 3), 40, 40);
  expect(await grid.count()).toBe(2);
  await page.getByRole("button", { name: "Reset the handle" }).click();
  expect(await grid.moved(3, 3)).toEqual([0, 0]);
  expect(await grid.count()).toBe(1);
});

test("the grid is pulled anywhere, and the picture still moves beside it", async ({ studio, page }) => {
  const grid = new Grid(page, studio);
  await grid.open();
  const low = await grid.place(2, 2);
  const high = await grid.place(3, 3);
  // Off all crossings and handles.
  const at = { x: low.x + 0.43 * (high.x - low.x), y: low.y + 0.43 * (high.y - low.y) };
  await test.step("with Alt", async () => {
    await page.keyboard.down("Alt");
    await grid.drag(at, 0, -60);
    await page.keyboard.up("Alt");
    expect(await grid.count()).toBe(16);
    const [near, far] = [await grid.moved(2, 2), await grid.moved(1, 4)];
    expect(near[0]).toBeCloseTo(0, 6);
    expect(near[1]).toBeGreaterThan(far[1] ?? 1);
    await page.getByRole("button", { name: "Undo", exact: true }).click();
    expect(await grid.count()).toBe(0);
  });
  await test.step("with the hand that pulls", async () => {
    await page.getByRole("radio", { name: "Pull" }).check();
    await grid.drag(at, 50, 0);
    expect(await grid.count()).toBe(16);
    await page.getByRole("button", { name: "Undo", exact: true }).click();
    await page.getByRole("radio", { name: "Move" }).check();
  });
  await test.step("at a crossing", async () => {
    const [left, right] = [await grid.place(1, 1), await grid.place(4, 4)];
    const crossing = { x: left.x + 0.4 * (right.x - left.x), y: left.y + 0.6 * (right.y - left.y) };
    await grid.drag(crossing, 30, 30);
    expect(await grid.count()).toBe(16);
    await page.getByRole("button", { name: "Undo", exact: true }).click();
  });
  await test.step("elsewhere the picture moves", async () => {
    // The view follows the handles, and glides back with them.
    await studio.drawn();
    await grid.drag(at, 40, 10);
    expect(await grid.count()).toBe(0);
    const moved = await grid.place(2, 2);
    expect(moved.x).toBeCloseTo(low.x + 40, 0);
    expect(moved.y).toBeCloseTo(low.y + 10, 0);
    await page.mouse.move(at.x, at.y);
    await page.mouse.wheel(0, -300);
    await expect(page.getByTestId("zoom")).not.toHaveText("×1.0");
  });
});

test("a wheel turned over a handle enlarges the picture", async ({ studio, page }) => {
  const grid = new Grid(page, studio);
  await grid.open();
  const at = await grid.place(2, 2);
  await page.mouse.move(at.x, at.y);
  await page.mouse.wheel(0, -400);
  await expect(page.getByTestId("zoom")).not.toHaveText("×1.0");
  // About the pointer: the handle is still under it, and is dragged where it is.
  const now = await grid.place(2, 2);
  expect(Math.abs(now.x - at.x)).toBeLessThan(2);
  await grid.drag(now, 30, 0);
  expect(await grid.count()).toBe(1);
});

test("what is out of sight is kept at the edge while keys are on it", async ({ studio, page }) => {
  const grid = new Grid(page, studio);
  await grid.open();
  const at = await grid.place(4, 4);
  await page.mouse.move(at.x, at.y);
  await page.mouse.wheel(0, -1500);
  await expect(grid.handle(1, 1)).toBeVisible();
  const stage = await page.locator(".stage").boundingBox();
  const handle = await grid.place(1, 1);
  expect(handle.x).toBeCloseTo(stage?.x ?? 0, 0);
  await grid.handle(1, 1).focus();
  await page.keyboard.press("ArrowRight");
  expect(await grid.count()).toBe(1);
  expect(await page.locator(".pane").evaluate((pane) => pane.scrollLeft + pane.scrollTop)).toBe(0);
});

test("axe finds nothing on the grid", async ({ studio, page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  const grid = new Grid(page, studio);
  await grid.open();
  await grid.drag(await grid.place(2, 2), 40, 40);
  await expectClean(page, ".stage");
});
