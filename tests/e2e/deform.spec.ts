import type { Page } from "@playwright/test";
import { expectClean } from "./axe";
import { expect, test } from "./fixture";

const GASKET = "v=1&a=gasket&b=gasket&path=straight&tool=deform";

const slider = (page: Page, name: string) => page.getByRole("slider", { name, exact: true });
const key = (page: Page, number: number) =>
  page.getByRole("slider", { name: new RegExp(`^Keyframe ${number} of`) });

test("a newcomer sees the grid and what to do, and one press shows it", async ({ studio, page }) => {
  await studio.open(GASKET);
  const before = await studio.look();
  await expect(page.getByText("Drag a point of the grid.")).toBeVisible();
  expect((await studio.scene()).deform).toBeUndefined();
  await page.getByRole("button", { name: "Show me" }).click();
  const after = await studio.look();
  expect(after.hash).not.toBe(before.hash);
  await expect(page.getByText("Drag a point of the grid.")).toHaveCount(0);
  await page.getByRole("button", { name: "Undo" }).click();
  expect((await studio.scene()).deform).toBeUndefined();
  expect((await studio.look()).hash).toBe(before.hash);
  await page.getByRole("button", { name: "Redo" }).click();
  await page.getByRole("button", { name: "Start over" }).click();
  expect((await studio.look()).hash).toBe(before.hash);
});

test("sliders go by keys, each run is one undo step, and plain can be held", async ({ studio, page }) => {
  await studio.open(GASKET);
  await page.getByRole("button", { name: "Show me" }).click();
  const fractal = await studio.look();
  await slider(page, "Locality").focus();
  await page.keyboard.press("End");
  await expect.poll(async () => (await studio.scene()).deform?.kb).toBe(9);
  const plain = await studio.look();
  expect(plain.hash).not.toBe(fractal.hash);
  await page.keyboard.press("Home");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Shift+ArrowRight");
  expect((await studio.scene()).deform?.kb).toBeCloseTo(0.11, 9);
  await slider(page, "Roughness").focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  expect((await studio.scene()).deform?.delta).toBeCloseTo(0.77, 9);
  const undo = page.getByRole("button", { name: "Undo" });
  await undo.click();
  expect((await studio.scene()).deform).toMatchObject({ delta: 0.75, kb: 0.11 });
  await undo.click();
  expect((await studio.scene()).deform).toMatchObject({ delta: 0.75, kb: 0 });
  expect((await studio.look()).hash).toBe(fractal.hash);

  const hold = page.getByRole("button", { name: "Hold for plain" });
  await hold.hover();
  await page.mouse.down();
  expect((await studio.look()).hash).toBe(plain.hash);
  await page.mouse.up();
  expect((await studio.look()).hash).toBe(fractal.hash);
  await hold.focus();
  await page.keyboard.down("Enter");
  expect((await studio.look()).hash).toBe(plain.hash);
  await page.keyboard.up("Enter");
  expect((await studio.look()).hash).toBe(fractal.hash);
  expect((await studio.scene()).deform?.kb).toBe(0);
});

test("detail takes locality along and gives it back, and bad numbers are refused", async ({
  studio,
  page,
}) => {
  await studio.open(GASKET);
  const locality = page.getByRole("spinbutton", { name: /^Locality/ });
  await locality.fill("5");
  await locality.press("Enter");
  await slider(page, "Detail").focus();
  for (let i = 0; i < 6; i++) await page.keyboard.press("PageDown");
  expect((await studio.scene()).deform).toMatchObject({ ke: 3, kb: 3 });
  for (let i = 0; i < 3; i++) await page.keyboard.press("PageUp");
  expect((await studio.scene()).deform).toMatchObject({ ke: 6, kb: 5 });
  await locality.fill("7");
  await locality.press("Enter");
  await expect(page.getByText("Enter at most 6.")).toBeVisible();
  const roughness = page.getByRole("spinbutton", { name: /^Roughness/ });
  await roughness.fill("lots");
  await roughness.press("Enter");
  await expect(page.getByText("A number cannot contain “lots”.")).toBeVisible();
  expect((await studio.scene()).deform).toMatchObject({ kb: 5, delta: 0.75 });
  await page.getByRole("switch", { name: "Varies by corner" }).check();
  await page.getByRole("spinbutton", { name: "Upper right" }).fill("1.25");
  await page.keyboard.press("Enter");
  expect((await studio.scene()).deform?.delta).toEqual([0.75, 0.75, 0.75, 1.25]);
});

test("a motion plays, changes the picture with time, and is one undo step", async ({ studio, page }) => {
  await studio.open("v=1&a=fern&b=fern&tool=deform");
  await studio.drawn();
  await page.getByRole("button", { name: "Sway" }).click();
  await expect(page.getByRole("button", { name: "Pause" })).toBeVisible();
  await expect.poll(async () => (await studio.scene()).deform?.phase ?? 0).toBeGreaterThan(0.05);
  await page.getByRole("button", { name: "Pause" }).click();
  expect((await studio.scene()).deform).toMatchObject({ spin: "scaled", loop: true });
  const at = async (percent: string) => {
    await page.getByRole("spinbutton", { name: "Time in percent" }).fill(percent);
    await page.keyboard.press("Enter");
    return (await studio.look()).hash;
  };
  const right = await at("25");
  expect(await at("75")).not.toBe(right);
  expect(await at("25")).toBe(right);
  await page.getByRole("button", { name: "Undo" }).click();
  expect((await studio.scene()).deform).toBeUndefined();
});

test("where nothing is to move by itself, nothing does", async ({ studio, page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await studio.open(GASKET);
  await page.getByRole("button", { name: "Breathe" }).click();
  await expect(page.getByRole("button", { name: "Play", exact: true })).toBeVisible();
  await studio.drawn();
  expect((await studio.scene()).deform?.phase).toBe(0.25);
});

test("key frames are added, moved, and deleted", async ({ studio, page }) => {
  await studio.open(GASKET);
  await studio.time.focus();
  for (let i = 0; i < 4; i++) await page.keyboard.press("PageUp");
  await page.locator("body").press("k");
  const keys = async () => (await studio.scene()).deform?.keys.map(({ at }) => at);
  expect(await keys()).toEqual([0, 0.4]);
  await key(page, 2).focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Alt+ArrowRight");
  expect(await keys()).toEqual([0, 0.51]);
  await page.getByRole("button", { name: "Undo" }).click();
  expect(await keys()).toEqual([0, 0.4]);
  const box = await key(page, 2).boundingBox();
  const track = await page.locator(".key-track").boundingBox();
  if (!box || !track) throw new Error("no key on the track");
  const [x, y] = [box.x + box.width / 2, box.y + 8];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 0.1 * track.width, y, { steps: 4 });
  await page.mouse.move(x + 0.2 * track.width, y, { steps: 4 });
  await page.mouse.up();
  expect((await keys())?.[1]).toBeCloseTo(0.6, 2);
  await page.getByRole("button", { name: "Undo" }).click();
  expect(await keys()).toEqual([0, 0.4]);
  await key(page, 2).focus();
  await page.keyboard.press("Delete");
  expect(await keys()).toEqual([0]);
  await page.getByRole("button", { name: "Undo" }).click();
  expect(await keys()).toEqual([0, 0.4]);
});

test("a shape of the gallery has the grid around it, and the link brings all of it back", async ({
  studio,
  page,
}) => {
  await studio.open(GASKET);
  await page.getByRole("button", { name: "Show me" }).click();
  const gasket = await studio.scene();
  await page.getByRole("button", { name: /Choose another shape$/ }).click();
  await page.getByRole("button", { name: /^Koch curve/ }).click();
  const koch = await studio.scene();
  expect(koch).toMatchObject({ a: { preset: "koch" }, t: 0 });
  expect(koch.deform?.box).not.toEqual(gasket.deform?.box);
  await page.getByRole("button", { name: "Undo" }).click();
  expect(await studio.scene()).toMatchObject({ a: { preset: "gasket" }, deform: gasket.deform });
  await page.getByRole("button", { name: "Redo" }).click();
  await page.getByRole("radio", { name: "Grid" }).check();
  await page.getByRole("radio", { name: "Smallest only" }).check();
  const look = await studio.look();
  const before = await studio.scene();
  await page.getByRole("button", { name: "Share", exact: true }).click();
  await page.getByRole("dialog", { name: "Share" }).waitFor();
  await studio.open(new URL(page.url()).hash.slice(1));
  expect(await studio.scene()).toEqual(before);
  expect((await studio.look()).hash).toBe(look.hash);
  await expect(page.getByRole("radio", { name: "Smallest only" })).toBeChecked();
});

test("axe finds nothing in the deformation tool", async ({ studio, page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await studio.open(GASKET);
  await studio.drawn();
  await expectClean(page);
  await page.getByRole("button", { name: "Wave" }).click();
  await page.getByRole("radio", { name: "Grid" }).check();
  await page.getByRole("switch", { name: "Varies by corner" }).check();
  for (const summary of await page.locator("details.fold > summary").all()) await summary.click();
  const field = page.getByRole("spinbutton", { name: "Duration in seconds" });
  await field.fill("0");
  await field.press("Enter");
  await studio.drawn();
  await expectClean(page);
  await field.press("Escape");
  await field.blur();
  await page.locator("body").press("?");
  await expect(page.getByText("Hide or show the grid")).toBeVisible();
  await expectClean(page);
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: /Choose another shape$/ }).click();
  await expectClean(page);
});

test("what is bent is shown when what bends is there, and never at rest before", async ({ studio, page }) => {
  const bent = "v=1&a=gasket&b=gasket&path=straight&mesh=4x4:0,0,1,1&bend=0,9,0.75&keys=0:6,0.3,0.2";
  await studio.open(bent, "?backend=canvas");
  const { hash } = await studio.look();
  let letGo = () => {};
  const held = new Promise<void>((resolve) => {
    letGo = resolve;
  });
  await page.route(/frond-bend_bg.*\.wasm$/, async (route) => {
    await held;
    await route.continue();
  });
  await studio.open(bent, "?backend=canvas");
  await expect(studio.verdict).toBeVisible();
  // Neither by the page, which shows something coarse at first, nor by a worker.
  const lit = () =>
    page.evaluate(() =>
      [...document.querySelectorAll<HTMLCanvasElement>(".picture canvas")].some((canvas) => {
        const { width, height } = canvas;
        const pixels = canvas.getContext("2d")?.getImageData(0, 0, width, height).data ?? [];
        return pixels.some((byte) => byte > 0);
      }),
    );
  await expect.poll(() => page.evaluate(() => window.frond?.locusProgress())).toBe(1);
  expect(await lit()).toBe(false);
  letGo();
  expect((await studio.look()).hash).toBe(hash);
});

test.describe("without what bends", () => {
  test.use({ expected: /frond-bend|Failed to load resource/ });

  test("the page says so", async ({ studio, page }) => {
    await page.route(/frond-bend_bg.*\.wasm$/, (route) => route.abort());
    await studio.open("v=1&a=gasket&b=gasket&path=straight&mesh=4x4:0,0,1,1&bend=0,9,0.75&keys=0:6,0.3,0.2");
    await expect
      .poll(() => studio.said())
      .toContainEqual(expect.stringMatching(/^The code for deformations could not be loaded/));
    // All else goes on.
    await expect(studio.verdict).toBeVisible();
  });
});
