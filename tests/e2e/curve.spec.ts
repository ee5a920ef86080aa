import { readFile } from "node:fs/promises";
import type { Page } from "@playwright/test";
import { expectClean } from "./axe";
import { expect, test } from "./fixture";
import { Grid } from "./grid";
import type { Studio } from "./studio";

const LEAVES = "v=1&a=gasket&b=gasket&path=straight&curve-a=maple&curve-b=oak";

const card = (page: Page, end: "A" | "B") =>
  page.getByRole("button", { name: new RegExp(`^Shape ${end}: `) });

async function choose(page: Page, end: "A" | "B", name: RegExp): Promise<void> {
  await card(page, end).click();
  await page.getByRole("region", { name: "Closed curves" }).getByRole("button", { name }).click();
  await expect(page.getByRole("dialog")).toHaveCount(0);
}

async function at(page: Page, percent: string): Promise<void> {
  await page.getByRole("spinbutton", { name: "Time in percent" }).fill(percent);
  await page.keyboard.press("Enter");
}

test("a curve for one end makes both ends curves, in one step, and a system brings both back", {
  tag: "@webgpu",
}, async ({ studio, page }) => {
  await studio.open("v=1&a=gasket&b=gasket&path=straight&view=0.5,0.5,3");
  const before = await studio.look();
  await choose(page, "A", /^Maple/);
  await expect(card(page, "A")).toHaveAccessibleName(
    /^Shape A: Maple.*, closed curve with \d+ knots, \d+ copies/,
  );
  expect((await studio.scene()).curves?.b.preset).toBe("white-oak");
  await expect
    .poll(() => studio.said())
    .toContainEqual(
      expect.stringMatching(/^Outlines morph only into outlines, so B is now Oak.* instead of Gasket\.$/),
    );
  await expect(studio.verdict).toHaveText("One closed curveby construction");
  const maple = await studio.look();
  expect(maple.hash).not.toBe(before.hash);
  // All of it is in view.
  expect(maple.box[0]).toBeGreaterThan(0);
  expect(maple.box[3]).toBeLessThan(maple.height - 1);

  await choose(page, "B", /^Snowflake/);
  expect((await studio.scene()).curves).toMatchObject({
    a: { preset: "sugar-maple" },
    b: { preset: "snowflake" },
  });
  // The notice has one of its own.
  const undo = page.getByRole("banner").getByRole("button", { name: "Undo" });
  await undo.click();
  expect((await studio.scene()).curves?.b.preset).toBe("white-oak");
  await undo.click();
  expect((await studio.scene()).curves).toBeUndefined();
  expect((await studio.look()).hash).toBe(before.hash);
  await page.getByRole("button", { name: "Redo" }).click();
  expect((await studio.look()).hash).toBe(maple.hash);

  await card(page, "B").click();
  const dialog = page.getByRole("dialog");
  // What goes with the outline comes first; of the rest it is said that it does not.
  await expect(dialog.getByRole("heading", { level: 3 }).first()).toHaveText("Closed curves");
  await expect(dialog).toContainText(/shape A becomes Gasket instead of Maple/);
  await expect(dialog).not.toContainText("one piece with");
  await dialog.getByRole("button", { name: /^Gasket/ }).click();
  await expect
    .poll(() => studio.said())
    .toContainEqual(
      expect.stringMatching(/^Outlines morph only into outlines, so A is now Gasket instead of Maple.*\.$/),
    );
  await expect(card(page, "B")).toHaveAccessibleName(/^Shape B: Gasket, 3 copies/);
  expect((await studio.scene()).curves).toBeUndefined();
  expect((await studio.scene()).b.preset).toBe("gasket");
});

test("it plays, is scrubbed, and has a film; both ends are the curves themselves", async ({
  studio,
  page,
}) => {
  await studio.open(LEAVES);
  const maple = await studio.look();
  await at(page, "100");
  const oak = await studio.look();
  await at(page, "50");
  const between = await studio.look();
  expect(new Set([maple.hash, oak.hash, between.hash]).size).toBe(3);
  await expect(studio.time).toHaveAttribute("aria-valuetext", "50%, one closed curve");
  await page.locator("body").press("]");
  await page.locator("body").press("[");
  expect((await studio.look()).hash).toBe(between.hash);

  const frames = page.getByRole("list", { name: "Film of the morph" }).getByRole("button");
  await expect(frames).toHaveCount(13);
  const lit = () =>
    page.locator(".film canvas").evaluateAll((all) =>
      all.map((canvas) => {
        const { width, height } = canvas as HTMLCanvasElement;
        const data =
          (canvas as HTMLCanvasElement).getContext("2d")?.getImageData(0, 0, width, height).data ?? [];
        let sum = 0;
        for (let i = 3; i < data.length; i += 4) sum += data[i] ? 1 : 0;
        return sum / (width * height);
      }),
    );
  await expect.poll(async () => Math.min(...(await lit()))).toBeGreaterThan(0.05);
  await frames.first().click();
  expect((await studio.look()).hash).toBe(maple.hash);

  await studio.time.press(" ");
  await expect.poll(async () => (await studio.scene()).t).toBeGreaterThan(0.05);
  await studio.time.press(" ");
  await expect(page.getByRole("button", { name: "Play", exact: true })).toBeVisible();

  await at(page, "0");
  await page.getByRole("button", { name: "Swap A and B" }).click();
  expect((await studio.scene()).t).toBe(1);
  // The same curve, begun at another knot.
  const swapped = await studio.look();
  expect(swapped.box).toEqual(maple.box);
  expect(Math.abs(swapped.lit / maple.lit - 1)).toBeLessThan(0.002);
});

/** Enlarges about a place on the outline, found anew at every step. */
async function dive(studio: Studio, page: Page, steps: number): Promise<void> {
  const stage = await page.locator(".picture").boundingBox();
  if (!stage) throw new Error("there is no stage");
  for (let i = 0; i < steps; i++) {
    await studio.drawn();
    const spot = await page.evaluate(async () => {
      if (!window.frond) throw new Error("the page has no hook");
      const { width, height, data } = await window.frond.readPixels();
      let best = { far: Number.POSITIVE_INFINITY, x: 0, y: 0 };
      for (let y = 0; y < height; y++) {
        for (let x = 0; x < width; x++) {
          const far = Math.hypot(x - width / 2, y - height / 2);
          if ((data[4 * (y * width + x) + 3] ?? 0) > 250 && far < best.far) best = { far, x, y };
        }
      }
      return { x: best.x / width, y: best.y / height };
    });
    await page.mouse.move(stage.x + spot.x * stage.width, stage.y + spot.y * stage.height);
    await page.mouse.wheel(0, -1440);
    await page.waitForTimeout(400);
  }
}

test("ten thousand times enlarged there is still an outline, as sharp as before", async ({
  studio,
  page,
}) => {
  await studio.open(`${LEAVES}&t=0.4`);
  const whole = await studio.look();
  await dive(studio, page, 4);
  await expect(page.getByTestId("zoom")).toHaveText(/^×\d\.\de\+[4-9]$/);
  const near = await studio.look();
  const share = near.lit / (near.width * near.height);
  expect(share).toBeGreaterThan(0.02);
  expect(share).toBeLessThan(0.98);
  // An outline, not a blur: as wide as it was, at least across the picture.
  const opaque = await page.evaluate(async () => {
    const { data } = (await window.frond?.readPixels()) ?? { data: new Uint8ClampedArray() };
    let count = 0;
    for (let i = 3; i < data.length; i += 4) count += (data[i] ?? 0) > 250 ? 1 : 0;
    return count;
  });
  expect(opaque).toBeGreaterThan(0.3 * near.height);
  expect(opaque).toBeLessThan(0.2 * near.width * near.height);
  await page.keyboard.press("f");
  expect((await studio.look()).hash).toBe(whole.hash);
});

test("the grid bends it, with its moment, and undo takes that back", async ({ studio, page }) => {
  const grid = new Grid(page, studio);
  await grid.open(`${LEAVES}&tool=deform`);
  const rest = await studio.look();
  await expect(page.getByText("A closed curve has no pieces that could rotate")).toBeVisible();
  await expect(page.getByText("Continuity")).toHaveCount(0);
  await grid.drag(await grid.place(4, 4), 60, -40);
  const bent = await studio.look();
  expect(bent.hash).not.toBe(rest.hash);
  // Every part answers: a plain bend is another one.
  const hold = page.getByRole("button", { name: "Hold for plain" });
  await hold.hover();
  await page.mouse.down();
  expect((await studio.look()).hash).not.toBe(bent.hash);
  await page.mouse.up();
  expect((await studio.look()).hash).toBe(bent.hash);
  // Moved by keys, too: one step back undoes the drag.
  await page.getByRole("button", { name: "Undo" }).click();
  expect((await studio.look()).hash).toBe(rest.hash);
  await page.getByRole("button", { name: "Sway" }).click();
  await expect.poll(async () => (await studio.scene()).deform?.phase ?? 0).toBeGreaterThan(0.03);
  await page.getByRole("button", { name: "Pause" }).click();
  await at(page, "25");
  expect((await studio.look()).hash).not.toBe(rest.hash);

  // Another curve in the same grid; then a system, and the grid goes along.
  await page.getByRole("button", { name: /Choose another shape$/ }).click();
  await page
    .getByRole("region", { name: "Closed curves" })
    .getByRole("button", { name: /^Snowflake/ })
    .click();
  expect((await studio.scene()).curves?.a.preset).toBe("snowflake");
  await page.getByRole("button", { name: /Choose another shape$/ }).click();
  await page.getByRole("dialog").getByRole("button", { name: /^Fern/ }).click();
  const after = await studio.scene();
  expect(after.curves).toBeUndefined();
  expect(after.a.preset).toBe("fern");
  await expect(page.getByText("Continuity")).toBeVisible();
  expect((await studio.look()).lit).toBeGreaterThan(100);
});

test("a picture is bent in its place, and the curve comes back", { tag: "@webgpu" }, async ({
  studio,
  page,
}) => {
  await studio.open(`${LEAVES}&tool=deform`);
  const curve = await studio.look();
  await page.getByRole("radio", { name: "Picture" }).check();
  // Another canvas takes its place, on a slow machine not at once.
  await expect.poll(async () => (await studio.look()).hash).not.toBe(curve.hash);
  await page.getByRole("radio", { name: "Shape" }).check();
  await expect.poll(async () => (await studio.look()).hash).toBe(curve.hash);
});

test("a link opens the same picture", async ({ studio, page }) => {
  await studio.open(`${LEAVES}&t=0.35`);
  await choose(page, "B", /^Island/);
  const grid = new Grid(page, studio);
  await page.getByRole("link", { name: "Deform" }).click();
  await grid.handle(1, 1).waitFor();
  await grid.drag(await grid.place(2, 4), 30, -50);
  await page.getByRole("link", { name: "Morph" }).click();
  const before = await studio.look();
  await expect(page).toHaveURL(/curve-b=island/);
  await page.waitForTimeout(500);
  const fragment = new URL(page.url()).hash.slice(1);
  await studio.open(fragment);
  expect((await studio.scene()).curves?.b.preset).toBe("island");
  expect((await studio.look()).hash).toBe(before.hash);
});

test("the panel leads back to the systems, which were there all the time", async ({ studio, page }) => {
  await studio.open(LEAVES);
  await studio.drawn();
  await page.getByRole("button", { name: "Back to systems of maps" }).click();
  await expect(card(page, "A")).toHaveAccessibleName(/^Shape A: Gasket/);
  await expect(page.getByRole("heading", { name: "Where it stays in one piece" })).toBeVisible();
  await page.getByRole("button", { name: "Undo" }).click();
  await expect(card(page, "A")).toHaveAccessibleName(/^Shape A: Maple/);
});

test("the moment is saved as a drawing, as points, as numbers and as a picture", async ({ studio, page }) => {
  await studio.open(`${LEAVES}&t=0.5`);
  await studio.drawn();
  const saved = async (kind: string) => {
    const download = page.waitForEvent("download");
    await page.getByRole("region", { name: "Save this moment" }).getByRole("button", { name: kind }).click();
    const file = await download;
    expect(file.suggestedFilename()).toMatch(
      new RegExp(`^frond-maple.*-oak.*-0\\.50\\.${kind.toLowerCase()}$`),
    );
    return readFile(await file.path());
  };
  const svg = (await saved("SVG")).toString();
  expect(svg).toMatch(/^<svg xmlns="http:\/\/www\.w3\.org\/2000\/svg" viewBox="0 0 [\d.]+ [\d.]+"/);
  expect(svg.match(/L/g)?.length).toBeGreaterThan(300);
  const points = (await saved("CSV")).toString().trim().split("\n");
  expect(points[0]).toBe("x,y");
  expect(points.length).toBeGreaterThan(300);
  const json = JSON.parse((await saved("JSON")).toString());
  expect(json.s).toBe(0.5);
  expect(json.a.knots.length).toBe(json.a.edges.length);
  expect(json.outline.length).toBe(points.length - 1);
  const png = await saved("PNG");
  expect(png.subarray(1, 4).toString()).toBe("PNG");
  expect(Math.max(png.readUInt32BE(16), png.readUInt32BE(20))).toBe(2400);

  const menu = page.getByRole("button", { name: "Save", exact: true });
  const download = page.waitForEvent("download");
  await menu.click();
  await page.getByRole("menuitem", { name: "Save as SVG" }).click();
  expect((await readFile(await (await download).path())).toString()).toBe(svg);
});

test("axe finds nothing", async ({ studio, page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await studio.open(`${LEAVES}&t=0.5`);
  await studio.drawn();
  await test.step("morph", () => expectClean(page));
  await test.step("why", async () => {
    await studio.verdict.click();
    await expectClean(page);
    await page.keyboard.press("Escape");
  });
  await test.step("gallery", async () => {
    await card(page, "A").click();
    await page.getByRole("region", { name: "Closed curves" }).waitFor();
    await expectClean(page);
    await page.keyboard.press("Escape");
  });
  await test.step("menu", async () => {
    await page.getByRole("button", { name: "Save", exact: true }).click();
    await expectClean(page);
    await page.keyboard.press("Escape");
  });
  await test.step("deform", async () => {
    await page.getByRole("link", { name: "Deform" }).click();
    await page.getByRole("button", { name: /^Column 1, row 1/ }).waitFor();
    await expectClean(page);
  });
});
