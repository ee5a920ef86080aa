import { expect, test } from "./fixture";

/** Dragon to gasket along the straight line falls apart on the way: the paper's Fig 5. */
const BREAKING = "a=dragon-3&b=gasket&path=straight";
/** As far as is seen. */
const HOLDS = /In one piece, proved|No gap seen/;

test("the slider scrubs by keys: the picture and the verdict follow", { tag: "@webgpu" }, async ({
  studio,
}) => {
  await studio.open(BREAKING);
  const start = await studio.look();
  await expect(studio.verdict).toHaveText(HOLDS);
  await studio.time.focus();
  await studio.time.press("ArrowRight");
  expect((await studio.scene()).t).toBe(0.01);
  await studio.time.press("Shift+ArrowRight");
  expect((await studio.scene()).t).toBe(0.011);
  await studio.time.press("PageUp");
  expect((await studio.scene()).t).toBeCloseTo(0.111);
  await studio.time.press("End");
  expect((await studio.scene()).t).toBe(1);
  const end = await studio.look();
  expect(end.hash).not.toBe(start.hash);
  await expect(studio.verdict).toHaveText(HOLDS);
  await studio.time.press("Home");
  expect(await studio.look()).toEqual(start);
});

test("time goes by the mouse, by itself, by the film and by numbers", async ({ studio, page }) => {
  await studio.open(BREAKING);
  await test.step("it is scrubbed by the mouse", async () => {
    const start = await studio.look();
    const box = await studio.time.boundingBox();
    if (!box) throw new Error("no slider");
    const y = box.y + box.height / 2;
    await page.mouse.move(box.x + 8, y);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 4, y, { steps: 4 });
    await page.mouse.move(box.x + box.width / 2, y, { steps: 4 });
    await page.mouse.up();
    expect((await studio.scene()).t).toBeCloseTo(0.5, 1);
    const middle = await studio.look();
    expect(middle.hash).not.toBe(start.hash);
    await expect(studio.verdict).toHaveText(/In pieces.*gap [\d.]+%/);
  });
  await test.step("it plays and pauses", async () => {
    await studio.time.press("Home");
    await page.getByRole("button", { name: "Play" }).click();
    await expect.poll(async () => (await studio.scene()).t).toBeGreaterThan(0.01);
    await page.getByRole("button", { name: "Pause" }).click();
    await expect(page.getByRole("button", { name: "Play" })).toBeVisible();
    const { t } = await studio.scene();
    const paused = await studio.look();
    expect((await studio.scene()).t).toBe(t);
    await page.locator("body").press(" ");
    await expect.poll(async () => (await studio.scene()).t).toBeGreaterThan(t + 0.02);
    await page.locator("body").press(" ");
    await expect(page.getByRole("button", { name: "Play" })).toBeVisible();
    expect((await studio.look()).hash).not.toBe(paused.hash);
  });
  await test.step("frames of the film say whether they hold, and bring one there", async () => {
    await studio.idle();
    const film = page.getByRole("list", { name: "Film of the morph" });
    const frames = film.getByRole("button");
    await expect(frames).toHaveCount(13);
    await expect(frames.first()).toHaveAccessibleName("At 0%: in one piece, proved");
    await expect(frames.last()).toHaveAccessibleName("At 100%: in one piece, proved");
    await expect(frames.nth(6)).toHaveAccessibleName(
      /^At 50%: in pieces, gap [\d.]+%, by Frond’s own bounds$/,
    );
    const blank = await film.locator("canvas").evaluateAll(
      (all) =>
        all.filter((canvas) => {
          const { width, height } = canvas as HTMLCanvasElement;
          const data = (canvas as HTMLCanvasElement).getContext("2d")?.getImageData(0, 0, width, height).data;
          return data?.every((x) => x === 0) !== false;
        }).length,
    );
    expect(blank).toBe(0);

    await frames.nth(6).click();
    expect((await studio.scene()).t).toBe(0.5);
    await expect(frames.nth(6)).toHaveAttribute("aria-current", "true");
    await expect(studio.verdict).toHaveText(/^In pieces/);
    await frames.nth(6).press("ArrowRight");
    await expect(frames.nth(7)).toBeFocused();
    expect((await studio.scene()).t).toBeCloseTo(7 / 12, 3);
    await page.locator("body").press("[");
    expect((await studio.scene()).t).toBe(0.5);
  });
  await test.step("time is told in numbers too", async () => {
    const field = page.getByRole("spinbutton", { name: "Time in percent" });
    await field.fill("37.5");
    await field.press("Enter");
    expect((await studio.scene()).t).toBe(0.375);
    await field.fill("140");
    await field.press("Enter");
    await expect(field).toHaveAttribute("aria-invalid", "true");
    await expect(field).toHaveAccessibleDescription(/100.*Still 37\.5/);
    expect((await studio.scene()).t).toBe(0.375);
    // What was made by hand is an undo step; a moment is none.
    await expect(page.getByRole("button", { name: "Undo", exact: true })).toBeDisabled();
  });
});

test("without the loop it stops at the end", async ({ studio, page }) => {
  await studio.open(`${BREAKING}&t=0.97`);
  await page.getByRole("button", { name: "Loop back and forth" }).click();
  await page.getByRole("radio", { name: "2×" }).check();
  await page.getByRole("button", { name: "Play" }).click();
  await expect.poll(async () => (await studio.scene()).t).toBe(1);
  await expect(page.getByRole("button", { name: "Play" })).toBeVisible();
  await expect(page).toHaveURL(/t=1$/);
});
