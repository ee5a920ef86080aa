import type { Locator, Page } from "@playwright/test";
import { expect, test } from "./fixture";

const DRAGON = "a=dragon-3&b=gasket&path=straight&t=0.5";

/** The field itself, which takes keys. */
const plane = (page: Page): Locator => page.getByRole("application", { name: /^Locus over / });

/** How the field is painted, as one number, once nothing is being worked out. */
function painted(page: Page): Promise<number> {
  return page.locator("canvas.locus-field").evaluate((canvas) => {
    const { width, height } = canvas as HTMLCanvasElement;
    const data = (canvas as HTMLCanvasElement).getContext("2d")?.getImageData(0, 0, width, height).data ?? [];
    let hash = 0;
    for (const x of data) hash = (Math.imul(hash, 31) + x) | 0;
    return hash;
  });
}

test.describe("with proofs of what is seen", () => {
  test.use({ proofs: true });

  test("the map takes the place of the stage, is as fine there as it is large, and goes back", async ({
    studio,
    page,
  }) => {
    await studio.open(DRAGON);
    await studio.idle();
    const width = async () => (await studio.square.boundingBox())?.width ?? 0;
    const stage = page.locator(".stage");
    const [small, before] = [await width(), await stage.boundingBox()];
    await page.locator("body").press("l");
    await expect.poll(width).toBeGreaterThan(1.5 * small);
    // The shape is in the corner, whole, and what is said of the map is said of the finer one.
    expect((await stage.boundingBox())?.width).toBeLessThan((before?.width ?? 0) / 2);
    await studio.idle();
    expect((await studio.look()).lit).toBeGreaterThan(1000);
    await expect(page.getByText("no gap seen (checked to 1/1200 of its size)")).toBeVisible();
    // It is taken hold of as in its panel.
    const { x, y } = await studio.place(-0.5, 1.5);
    await page.mouse.click(x, y);
    await expect.poll(async () => (await studio.scene()).locus?.at?.[0] ?? 0).toBeCloseTo(-0.5, 1);
    await page.keyboard.press("Escape");
    await expect.poll(width).toBe(small);
    expect(await stage.boundingBox()).toEqual(before);
    await expect(page.getByText("no gap seen (checked to 1/600 of its size)")).toBeVisible();
  });
});

test("the map is enlarged by wheel, keys, buttons and numbers, and moved by hand", async ({
  studio,
  page,
}) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await studio.open(DRAGON);
  await studio.idle();
  const home = await painted(page);
  await test.step("wheel: what is under the pointer stays there", async () => {
    const { x, y } = await studio.place(1.4, 0.3);
    await page.mouse.move(x, y);
    // Whoever scrolls past does not lose the place.
    await page.mouse.wheel(0, -300);
    await expect(page.getByText("Click the locus, or hold Ctrl, to zoom with the wheel")).toBeVisible();
    expect((await studio.scene()).locus).toBeUndefined();
    await page.mouse.down();
    await page.mouse.move(x + 8, y);
    await page.mouse.move(x, y);
    await page.mouse.up();
    for (let i = 0; i < 3; i++) await page.mouse.wheel(0, -300);
    await expect.poll(async () => (await studio.scene()).locus?.zoom ?? 1).toBeGreaterThan(4);
    const view = (await studio.scene()).locus;
    if (!view) throw new Error("no view");
    // (1.4, 0.3) was 0.4 to the right of the middle, of a half of 1.5, and 0.2 / 1.5 below.
    const half = 1.5 / view.zoom;
    expect(1.4 - view.x).toBeCloseTo(half * (0.9 / 1.5), 1);
    expect(0.3 - view.y).toBeCloseTo(half * (-0.2 / 1.5), 1);
  });
  await test.step("drag", async () => {
    const before = (await studio.scene()).locus;
    const { x, y } = await studio.place(0.6, 1.1);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 40, y, { steps: 4 });
    await page.mouse.up();
    const after = (await studio.scene()).locus;
    expect(after?.x).toBeLessThan(before?.x ?? 0);
    expect(after?.zoom).toBe(before?.zoom);
    // It was no press: the picture stays on the path.
    expect(after?.at).toBeUndefined();
  });
  await studio.idle();
  const near = await painted(page);
  expect(near).not.toBe(home);
  await test.step("a link holds the view", async () => {
    await expect(page).toHaveURL(/locus=/);
    await page.reload();
    await studio.idle();
    expect(await painted(page)).toBe(near);
  });
  await test.step("keys", async () => {
    const zoom = (await studio.scene()).locus?.zoom ?? 1;
    await plane(page).focus();
    await page.keyboard.press("+");
    expect((await studio.scene()).locus?.zoom).toBeCloseTo(1.5 * zoom, 2);
    await page.keyboard.press("0");
    expect((await studio.scene()).locus).toBeUndefined();
    await studio.idle();
  });
  await test.step("buttons", async () => {
    await page.getByRole("button", { name: "Zoom in" }).click();
    expect((await studio.scene()).locus?.zoom).toBe(2);
    await page.getByRole("button", { name: "Reset the view" }).click();
    expect((await studio.scene()).locus).toBeUndefined();
  });
  await test.step("numbers, down to the limit", async () => {
    await page.locator(".window-numbers summary").click();
    const times = page.getByRole("spinbutton", { name: "Zoom" });
    await times.fill("1e13");
    await times.press("Enter");
    expect((await studio.scene()).locus?.zoom).toBe(1e13);
    await expect(page.locator(".window-numbers")).toContainText("within 10⁻¹⁴");
    await times.fill("1e14");
    await times.press("Enter");
    await expect(times).toHaveAttribute("aria-invalid", "true");
    expect((await studio.scene()).locus?.zoom).toBe(1e13);
    // What lies on no map is not shown either.
    const at = page.getByRole("spinbutton", { name: /^Show the shape at/ });
    await at.fill("1e308");
    await at.press("Enter");
    await expect(at).toHaveAttribute("aria-invalid", "true");
    expect((await studio.scene()).locus?.at).toBeUndefined();
  });
});

test("a point of the map is looked at and taken, and there are ways back", async ({ studio, page }) => {
  await studio.open(DRAGON);
  await test.step("what is pointed at is shown, by hand and by keys", async () => {
    await studio.idle();
    const card = page.locator(".locus-preview");
    await expect(card).toBeHidden();
    const { x, y } = await studio.place(1.8, 0.2);
    await page.mouse.move(x, y);
    await expect(card).toBeVisible();
    await expect(card).toContainText(/In pieces, gap [\d.]+%, by Frond’s own bounds.*u 1\.80 {2}v 0\.20/);
    await page.mouse.move(10, 300);
    await expect(card).toBeHidden();
    // Nothing was taken.
    expect((await studio.scene()).locus).toBeUndefined();

    await plane(page).focus();
    await page.keyboard.press("ArrowRight");
    await expect(card).toBeVisible();
    await expect(card).toContainText(/u 0\.5[78]/);
    await page.keyboard.press("Enter");
    expect((await studio.scene()).locus?.at?.[0]).toBeCloseTo(0.575, 2);
    await page.keyboard.press("Escape");
    await expect(card).toBeHidden();
    await page.getByRole("button", { name: "Back to the path" }).click();
  });
  await test.step("a press takes a point off the path; undo, the slider and a button lead back", async () => {
    const before = await studio.look();
    // Never twice at one place: on a fast machine that is a double click, which zooms.
    const press = async (v: number) => {
      const { x, y } = await studio.place(-0.5, v);
      await page.mouse.click(x, y);
      await expect(page.getByRole("button", { name: "Back to the path" })).toBeVisible();
    };
    await press(0.5);
    const at = (await studio.scene()).locus?.at;
    expect(at?.[0]).toBeCloseTo(-0.5, 1);
    expect(at?.[1]).toBeCloseTo(0.5, 1);
    expect((await studio.look()).hash).not.toBe(before.hash);
    await page.getByRole("button", { name: "Undo", exact: true }).click();
    expect((await studio.scene()).locus).toBeUndefined();
    expect(await studio.look()).toEqual(before);
    await page.getByRole("button", { name: "Redo", exact: true }).click();
    expect((await studio.scene()).locus?.at).toEqual(at);
    await page.getByRole("button", { name: "Back to the path" }).click();
    expect(await studio.look()).toEqual(before);

    await press(0.2);
    await studio.time.focus();
    await studio.time.press("PageUp");
    expect((await studio.scene()).locus).toBeUndefined();
    expect((await studio.scene()).t).toBeCloseTo(0.6, 5);

    await press(0.8);
    await page.getByRole("button", { name: "Add as waypoint" }).click();
    const { locus, path } = await studio.scene();
    expect(locus).toBeUndefined();
    expect(path.kind).toBe("drawn");
    expect(path.points[0]?.[0]).toBeCloseTo(-0.5, 1);
  });
});

test("a slice off the path says so, and can be cut through the picture", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&path=drawn:0.5,0.5,0.4&t=0.5");
  await studio.idle();
  const plain = await painted(page);
  await page.getByText("Third parameter:").first().click();
  await page.getByRole("button", { name: "Show the locus there" }).click();
  expect((await studio.scene()).locus?.w).toBeCloseTo(0.4, 2);
  await studio.idle();
  expect(await painted(page)).not.toBe(plain);
  await page.getByRole("slider", { name: "Stretch leads rotation by w" }).press("Home");
  expect((await studio.scene()).locus?.w).toBe(-1);
  await studio.idle();
});

test("the set M, beside what is proved of it", async ({ studio, page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await studio.open("a=dragon-3&b=gasket&path=straight");
  await page.getByRole("radio", { name: "Pairs (M)" }).check();
  await studio.idle();
  expect((await studio.scene()).locus).toMatchObject({ family: "polygon", sides: 2, zoom: 1 });
  const whole = await painted(page);
  await page.getByRole("button", { name: "Twin dragon" }).click();
  const { locus } = await studio.scene();
  expect(locus).toMatchObject({ at: [0.5, 0.5], x: 0.5, y: 0.5 });
  await studio.idle();
  expect(await painted(page)).not.toBe(whole);
  await expect(studio.verdict).toHaveText(/In one piece/);
  // What others proved, and what Frond finds by itself.
  await expect(page.locator(".critical")).toContainText(/0\.500000000.*0\.(5000000|4999999)/);

  // What belongs to the morph gives way to the way of s.
  await expect(page.getByRole("radio", { name: "Auto" })).toHaveCount(0);
  await page.getByRole("slider", { name: "Angle of s around 0" }).press("ArrowRight");
  const [x = 0, y = 0] = (await studio.scene()).locus?.at ?? [];
  expect(Math.hypot(x, y)).toBeCloseTo(Math.SQRT1_2, 6);
  expect([x, y]).not.toEqual([0.5, 0.5]);
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  expect((await studio.scene()).locus?.at).toEqual([0.5, 0.5]);

  await page.getByRole("button", { name: "Use as A" }).click();
  const { a } = await studio.scene();
  expect(a.maps).toHaveLength(2);
  expect(a.maps[0]?.[0]).toBeCloseTo(0.5, 9);
  await page.getByRole("radio", { name: "This morph" }).check();
  expect((await studio.scene()).locus).toBeUndefined();

  await page.getByRole("radio", { name: "Polygons" }).check();
  const corners = page.getByRole("spinbutton", { name: "Corners n" });
  await corners.fill("5");
  await corners.press("Enter");
  expect((await studio.scene()).locus?.sides).toBe(5);
  await studio.idle();
  await expect(page.locator(".critical")).toContainText(/0\.381966011.*0\.38196/);
});

test("a view that cannot be shown is replaced by all of the map", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&locus=morph:900,0.5,8");
  await expect
    .poll(() => studio.said())
    .toContainEqual(expect.stringMatching(/cannot be shown|Frond shows what/));
  expect((await studio.scene()).locus).toBeUndefined();
  await expect(page.locator(".locus-problem")).toHaveCount(0);
  await studio.idle();
});
