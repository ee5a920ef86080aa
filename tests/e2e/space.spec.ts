import { readFile } from "node:fs/promises";
import type { Page } from "@playwright/test";
import { expectClean } from "./axe";
import { expect, test } from "./fixture";

// A picture of space costs by its pixels. In a narrower header the menu of Save is in another.
test.use({ viewport: { width: 900, height: 480 } });

/** A small scene is complete sooner than what is seen first. */
const TETRAHEDRON = "tool=space&space=o:tetrahedron";

const stage = (page: Page) => page.getByTestId("space-stage");
const status = (page: Page) => page.getByTestId("space-status");
/** Smoothed as well: nothing is left to do. */
const complete = (page: Page) => expect(status(page)).toHaveText("Complete picture", { timeout: 120_000 });
/** Every pixel that a piece reaches is lit. */
const whole = (page: Page) => expect(status(page)).toHaveText(/^Complete picture/, { timeout: 120_000 });
const packed = async (studio: { scene(): Promise<{ space?: { packed: string } }> }) =>
  (await studio.scene()).space?.packed ?? "";

async function choose(page: Page, name: string): Promise<void> {
  await page.getByRole("button", { name: /Choose another shape$/ }).click();
  const gallery = page.getByRole("dialog", { name: "Shapes in space" });
  await gallery.getByRole("button", { name: new RegExp(`^${name}`) }).click();
  await expect(gallery).toHaveCount(0);
}

test(
  "what is seen first is complete, and drawn by the graphics interface that was asked for",
  { tag: "@webgpu" },
  async ({ studio, page }, { project }) => {
    // By itself the page draws without it where the processor stands in for a card.
    await studio.open("tool=space", `?backend=${project.name}`);
    await complete(page);
    const first = await studio.look();
    expect(await page.evaluate(() => window.frond?.backend())).toBe(project.name);
    expect(first.lit).toBeGreaterThan(0.15 * first.width * first.height);
    expect(first.colours.length).toBeGreaterThan(200);
    // Nothing changes by itself.
    await page.waitForTimeout(500);
    expect((await studio.look()).hash).toBe(first.hash);
  },
);

test("without a graphics card what moves is carved as at rest, and comes to rest as the same picture", async ({
  studio,
  page,
}) => {
  await studio.open(TETRAHEDRON, "?backend=canvas");
  await complete(page);
  const first = await studio.look();
  const box = await stage(page).boundingBox();
  if (!box) throw new Error("no stage");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 40, y, { steps: 5 });
  await expect.poll(async () => (await studio.look()).hash).not.toBe(first.hash);
  await page.mouse.move(x + 80, y, { steps: 20 });
  const moving = await studio.look();
  // No fur of points: as much is lit as when it rests there.
  await page.mouse.up();
  await complete(page);
  const rested = await studio.look();
  expect(Math.abs(moving.lit - rested.lit)).toBeLessThan(0.3 * rested.lit);
  await page.keyboard.press("0");
  await complete(page);
  expect((await studio.look()).hash).toBe(first.hash);
});

test("it is looked at from all round, turned by hand, and undo brings every bit back", async ({
  studio,
  page,
}) => {
  await studio.open(TETRAHEDRON);
  await complete(page);
  const first = await studio.look();
  await test.step("looking round is another picture, and nothing to undo", async () => {
    await stage(page).focus();
    await page.keyboard.press("ArrowLeft");
    await expect(status(page)).toHaveText(/points|Complete/);
    await complete(page);
    const turned = await studio.look();
    expect(turned.hash).not.toBe(first.hash);
    await expect(page.getByRole("button", { name: "Undo", exact: true })).toBeDisabled();
    await page.keyboard.press("0");
    await complete(page);
    expect((await studio.look()).hash).toBe(first.hash);
  });
  await test.step("a hand turns it by its parameters", async () => {
    const made = [await packed(studio), first.hash];
    const table = page.getByRole("region", { name: "Parameters", exact: true });
    await expect(table).toContainText("All as made");
    await page.getByRole("radio", { name: "Rotate", exact: true }).first().check({ force: true });
    const box = await stage(page).boundingBox();
    if (!box) throw new Error("no stage");
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 60, y + 20, { steps: 4 });
    await page.mouse.move(x + 120, y - 30, { steps: 4 });
    await page.mouse.up();
    await expect(table).toContainText(/of 48 numbers are not as made/);
    await expect(table).toContainText("the same picture");
    await complete(page);
    const turned = (await studio.look()).hash;
    expect(turned).not.toBe(made[1]);
    // The whole drag is one step, and exactly undone.
    await page.getByRole("button", { name: "Undo", exact: true }).click();
    await expect(table).toContainText("All as made");
    expect(await packed(studio)).toBe(made[0]);
    await complete(page);
    expect((await studio.look()).hash).toBe(made[1]);
    await page.getByRole("button", { name: "Redo", exact: true }).click();
    await complete(page);
    expect((await studio.look()).hash).toBe(turned);
  });
  await test.step("a mesh of it is as large as was told before", async () => {
    await page.getByRole("button", { name: "Save", exact: true }).click();
    await page.getByRole("menuitem", { name: "Mesh for 3-D printing …" }).click();
    const dialog = page.getByRole("dialog", { name: "Mesh for 3-D printing" });
    const fineness = dialog.getByLabel("Resolution");
    await fineness.fill("48");
    await fineness.press("Enter");
    const told = dialog.getByText(/ mm · \d+ 000 triangles · /);
    await expect(told).toBeVisible({ timeout: 60_000 });
    await expectClean(page);
    const thousands = Number(/(\d+) 000 triangles/.exec(await told.innerText())?.[1]);
    const download = page.waitForEvent("download");
    await dialog.getByRole("button", { name: "Save the mesh" }).click();
    const stl = await readFile(await (await download).path());
    const triangles = stl.readUInt32LE(80);
    expect(stl.length).toBe(84 + 50 * triangles);
    expect(Math.round(triangles / 1000)).toBe(thousands);
    await expect(dialog).toHaveCount(0);
  });
  await test.step("nothing of it stands in the way of anybody", async () => {
    for (const part of ["Shape", "Morph", "Light", "Time"]) {
      await page.getByRole("radio", { name: part, exact: true }).check({ force: true });
      await expectClean(page);
    }
  });
});

test("a flight through the natural scene is keyed, exported as a film that plays, and sent as a link", async ({
  studio,
  page,
  browser,
}) => {
  test.setTimeout(420_000);
  // A lower window has the flights in a menu.
  await page.setViewportSize({ width: 900, height: 560 });
  await studio.open(TETRAHEDRON);
  await choose(page, "A natural scene");
  await page.getByRole("button", { name: "Fly through" }).first().click();
  const keys = page.getByRole("button", { name: /^Keyframe \d of \d/ });
  await expect.poll(() => keys.count()).toBeGreaterThanOrEqual(3);
  await studio.time.focus();
  await page.keyboard.press("End");
  for (let i = 0; i < 5; i++) await page.keyboard.press("ArrowLeft");
  const before = await keys.count();
  await page.getByRole("button", { name: "Set keyframe" }).click();
  await expect(keys).toHaveCount(before + 1);
  // By the keyboard alone it is made to go to and fro.
  const after = page.getByRole("button", { name: /^Loop: / });
  await after.press("Enter");
  await page.getByRole("menuitem", { name: "None", exact: true }).press("End");
  await page.keyboard.press("Enter");
  await expect(after).toHaveAccessibleName("Loop: back and forth");
  expect(await packed(studio)).toContain("/time:12,2,");
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await expect(page.getByRole("button", { name: "Pause", exact: true })).toBeVisible();
  await page.getByRole("button", { name: "Pause", exact: true }).click();

  await page.getByRole("button", { name: "Export …" }).click();
  const dialog = page.getByRole("dialog", { name: "Export" });
  await dialog.getByRole("radio", { name: "WebM" }).check({ force: true });
  for (const [name, value] of [
    ["Width", "160"],
    ["Height", "90"],
    ["Frames per second", "10"],
    ["To", "1"],
  ] as const) {
    const field = dialog.getByRole("spinbutton", { name, exact: true });
    await field.fill(value);
    await field.press("Enter");
  }
  const download = page.waitForEvent("download", { timeout: 300_000 });
  await dialog.getByRole("button", { name: "Render the film" }).click();
  const bytes = await readFile(await (await download).path());
  // EBML: what WebM begins with.
  expect([...bytes.subarray(0, 4)]).toEqual([0x1a, 0x45, 0xdf, 0xa3]);
  const film = dialog.locator("video");
  const played = await film.evaluate(async (video: HTMLVideoElement) => {
    const moving = new Promise((resolve) => {
      video.addEventListener("timeupdate", () => video.currentTime > 0 && resolve(null));
    });
    await video.play();
    await moving;
    return { width: video.videoWidth, height: video.videoHeight, at: video.currentTime };
  });
  expect(played).toMatchObject({ width: 160, height: 90 });
  expect(played.at).toBeGreaterThan(0);
  await page.keyboard.press("Escape");

  await studio.time.focus();
  await page.keyboard.press("Home");
  await whole(page);
  await page.waitForTimeout(600);
  await expect(page).toHaveURL(/space=/);
  const mine = await studio.scene();
  const other = await browser.newPage({ viewport: page.viewportSize(), serviceWorkers: "block" });
  await other.goto(page.url());
  await expect.poll(() => other.evaluate(() => window.frond?.scene())).toEqual(mine);
  await other.close();
});

test("no object of several leaves unasked, and the background goes with the link", async ({
  studio,
  page,
  browser,
}) => {
  await studio.open(TETRAHEDRON);
  await choose(page, "A natural scene");
  const objects = page.getByRole("radiogroup", { name: "Selected object", exact: true }).getByRole("radio");
  await expect(objects).toHaveCount(13);
  // By keys alone.
  const card = page.getByRole("button", { name: "Meadow. Choose another shape" });
  await card.press("Enter");
  await page.getByRole("dialog").locator("button:focus").waitFor();
  await page.keyboard.press("Home");
  await page.keyboard.press("Enter");
  const asked = page.getByRole("dialog", { name: /^Where should .* go\?$/ });
  await expect(asked.getByRole("button", { name: /^Add/ })).toBeFocused();
  await expect(objects).toHaveCount(13);
  await page.keyboard.press("Tab");
  await expect(asked.getByRole("button", { name: /^Replace Meadow/ })).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(page.getByText(/replaces Meadow/).first()).toBeVisible();
  await expect(card).toHaveCount(0);
  await page.locator(".notices").getByRole("button", { name: "Undo" }).click();
  await expect(card).toBeVisible();

  await page.getByRole("radio", { name: "Light", exact: true }).first().check({ force: true });
  await page
    .getByRole("radiogroup", { name: "Background" })
    .getByRole("radio", { name: "Dark" })
    .check({ force: true });
  const colour = (on: Page) => stage(on).evaluate((element) => getComputedStyle(element).backgroundColor);
  expect(await colour(page)).toBe("rgb(14, 16, 21)");
  await page.waitForTimeout(600);
  const other = await browser.newPage({
    viewport: page.viewportSize(),
    colorScheme: "light",
    serviceWorkers: "block",
  });
  await other.goto(page.url());
  await stage(other).waitFor();
  await expect.poll(() => colour(other)).toBe("rgb(14, 16, 21)");
  await other.close();
});

test("a link of before casts no shadows, and what is chosen of light is in the link and is undone", async ({
  studio,
  page,
}) => {
  await studio.open(TETRAHEDRON);
  await complete(page);
  const [before, word] = [await studio.look(), await packed(studio)];
  expect(word).not.toContain("/f:");
  await page.getByRole("radio", { name: "Light", exact: true }).first().check({ force: true });
  await page.getByText("Shadows and material").click();
  const shadows = page.getByRole("slider", { name: "Shadows", exact: true });
  await expect(shadows).toHaveValue("0");
  await shadows.focus();
  await page.keyboard.press("End");
  await expect.poll(() => packed(studio)).toContain("o:tetrahedron/f:1,0,0,0,0,0");
  await complete(page);
  const shaded = await studio.look();
  expect(shaded.hash).not.toBe(before.hash);
  // It is the same shape, and darker.
  expect(shaded.lit).toBe(before.lit);
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  await expect.poll(() => packed(studio)).toBe(word);
  await complete(page);
  expect((await studio.look()).hash).toBe(before.hash);
});

test("the tetrahedron becomes a dragon on a path that holds", async ({ studio, page }) => {
  test.setTimeout(400_000);
  await studio.open(TETRAHEDRON);
  await page.getByRole("radio", { name: "Morph", exact: true }).check({ force: true });
  await page.getByRole("button", { name: "Tetrahedron to the dragon in space" }).first().click();
  await expect.poll(() => packed(studio), { timeout: 200_000 }).toContain("/way:auto;");
  const place = page.getByRole("slider", { name: "Time along the path", exact: true });
  await place.focus();
  for (let i = 0; i < 3; i++) await page.keyboard.press("PageUp");
  await expect.poll(() => packed(studio)).toMatch(/\/t:0\.\d/);
  await complete(page);
  const { lit, width, height } = await studio.look();
  expect(lit).toBeGreaterThan(0.04 * width * height);
  await expect(page.getByText(/In one piece, proved|No gap seen/).first()).toBeVisible();
});

test("a shadow along a direction that is kept goes on into the morph", async ({ studio, page }) => {
  await studio.open(TETRAHEDRON);
  await page.getByText("Shadow on a plane").click();
  await page.getByRole("button", { name: "Morph it" }).click();
  await expect(page.getByRole("link", { name: "Morph", exact: true })).toHaveAttribute("aria-current");
  const { a, tool } = await studio.scene();
  expect([a.maps.length, tool ?? "morph"]).toEqual([4, "morph"]);
  await studio.drawn();
  expect((await studio.look()).lit).toBeGreaterThan(2000);
});

test("what cannot be is refused, and the work stays", async ({ studio, page }) => {
  await studio.open("tool=space&space=o:nothing");
  await whole(page);
  await expect.poll(async () => (await studio.said()).join()).toContain("damaged");
  // Everything behind the eye: said, with a way back.
  await studio.open(`${TETRAHEDRON}&space-view=0,50,0,1,0,0,0.7`);
  await expect(page.getByText("Everything is behind the eye.")).toBeVisible();
  await page.getByRole("button", { name: "Show all", exact: true }).last().click();
  await whole(page);
  expect((await studio.look()).lit).toBeGreaterThan(5000);
  // An eye inside the sponge still has a picture.
  await studio.open("tool=space&space=o:sponge&space-view=0,0,0,0.05,0.3,0.1,0.9");
  await whole(page);
  expect((await studio.look()).lit).toBeGreaterThan(1000);
  // A file that is none.
  const before = await packed(studio);
  const chooser = page.waitForEvent("filechooser");
  await page.getByRole("button", { name: "Open .ifs…" }).click();
  await (await chooser).setFiles({
    name: "bad.ifs",
    mimeType: "text/plain",
    buffer: Buffer.from("broken (3D) { 1 2 3 }"),
  });
  await expect.poll(async () => (await studio.said()).join()).toContain("broken");
  expect(await packed(studio)).toBe(before);
});

test("a lost device is replaced, and the picture is the same", { tag: "@webgpu" }, async ({
  studio,
  page,
}) => {
  await studio.open("tool=space&space=o:octahedron");
  await complete(page);
  const before = (await studio.look()).hash;
  await page.evaluate(() => window.frond?.forceLoss());
  await expect.poll(async () => (await studio.said()).join()).toContain("stopped responding");
  await complete(page);
  expect((await studio.look()).hash).toBe(before);
});
