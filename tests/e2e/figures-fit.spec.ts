import type { Locator, Page } from "@playwright/test";
import { expectClean } from "./axe";
import { idsOf, open } from "./figure-pages";
import { expect, test } from "./fixture";

const PAGES = idsOf("rough-curves");

interface Look {
  /** Parts of the picture that hold something. */
  lit: number;
  hash: number;
}

/** What is on a canvas. */
function look(picture: Locator): Promise<Look> {
  return picture.evaluate((canvas) => {
    if (!(canvas instanceof HTMLCanvasElement)) throw new Error("not a canvas");
    const { width, height } = canvas;
    const image = canvas.getContext("2d")?.getImageData(0, 0, width, height);
    const pixels = new Uint32Array(image?.data.buffer ?? new ArrayBuffer(0));
    return {
      lit: pixels.filter((pixel) => pixel >>> 24 > 0).length / Math.max(1, pixels.length),
      hash: pixels.reduce((hash, pixel) => Math.imul(hash ^ pixel, 0x01000193), 0x811c9dc5),
    };
  });
}

async function expectChange(picture: Locator, act: () => Promise<unknown>): Promise<void> {
  const before = await look(picture);
  await act();
  await expect.poll(async () => (await look(picture)).hash).not.toBe(before.hash);
  expect((await look(picture)).lit).toBeGreaterThan(0.001);
}

/** Every picture of a page holds something. */
async function expectDrawn(page: Page): Promise<void> {
  const pictures = page.getByRole("main").locator("canvas[role=img]");
  const count = await pictures.count();
  expect(count).toBeGreaterThan(0);
  for (let i = 0; i < count; i++) {
    const picture = pictures.nth(i);
    const name = await picture.getAttribute("aria-label");
    await expect
      .poll(async () => (await look(picture)).lit, { message: name ?? "", timeout: 60_000 })
      .toBeGreaterThan(0.001);
  }
}

/** Lets the leaf's fit come far enough to be seen, and no farther. */
async function stopFit(page: Page): Promise<void> {
  const curve = page.getByRole("img", { name: /^Frond’s closed curve of 290 numbers/ });
  await expect(curve).toHaveAccessibleName(/% off$/, { timeout: 60_000 });
  await page.getByRole("button", { name: "Stop" }).click();
  await expect(page.getByText("stopped: the best so far").first()).toBeVisible();
  await expect(page.getByRole("img", { name: /^Where two of 29 copies/ })).toHaveAccessibleName(/a gap of/, {
    timeout: 60_000,
  });
}

for (const figure of PAGES) {
  test(`${figure} is drawn, and clean in both themes`, async ({ page }) => {
    test.setTimeout(120_000);
    await page.emulateMedia({ reducedMotion: "reduce" });
    await open(page, figure);
    const badge = /^(reconstructed|as printed)$/;
    await expect(page.getByRole("main").getByText(badge)).toBeVisible();
    if (figure === "c7") await stopFit(page);
    await expectDrawn(page);
    await expectClean(page);
    await page.emulateMedia({ colorScheme: "dark", reducedMotion: "reduce" });
    await expectClean(page);
  });
}

test("all are in the index, under the numbers of the paper too", async ({ page }) => {
  await open(page, "");
  const section = page.getByRole("region", { name: "Rough curves from a few maps" });
  await expect(section.getByRole("listitem")).toHaveCount(PAGES.length);
  for (const canvas of await section.locator("canvas").all()) {
    expect((await look(canvas)).lit).toBeGreaterThan(0.001);
  }
  for (const [id, title] of [
    ["ct1", "A mountain range of ten numbers"],
    ["ct3", "Seven maps, or eleven"],
  ] as const) {
    await open(page, id);
    await expect(page.getByRole("heading", { level: 1, name: title })).toBeVisible();
  }
});

test("Figure 1 is moved by mouse, keys, sliders and numbers", async ({ page }) => {
  await open(page, "c1");
  const curve = page.getByRole("img", { name: /^The curve through/ });
  await expect(page.getByText("dimension 1.000", { exact: false })).toBeVisible();
  const middle = page.getByRole("button", { name: /^Middle point/ });
  await expectChange(curve, async () => {
    await middle.focus();
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("ArrowRight");
  });
  await expect(middle).toHaveAccessibleName(/t = 0\.52, x = 1\.02/);
  await expectChange(curve, () => page.getByRole("slider", { name: /left piece/ }).press("End"));
  await expect(page.getByText(/dimension 1\.[1-9]/)).toBeVisible();
  await expectChange(curve, async () => {
    const box = await middle.boundingBox();
    if (!box) throw new Error("the point is not on the page");
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 - 60, box.y + box.height / 2 + 40, { steps: 4 });
    await page.mouse.up();
  });
  await expectChange(curve, async () => {
    const field = page.getByRole("spinbutton", { name: /^Last point/ });
    await field.fill("1/2");
    await field.press("Enter");
  });
  await expect(curve).toHaveAccessibleName(/\(1, 0\.5\)/);
  await expectChange(curve, () => page.getByRole("switch", { name: "Right copy runs backwards" }).check());
});

test("Figure 2 shows the step where its pieces should meet", async ({ page }) => {
  await open(page, "c2");
  await expect(page.getByText("0.988875")).toBeVisible();
  await expect(page.getByRole("cell", { name: "0.746" })).toBeVisible();
  const closer = page.getByRole("img", { name: /^The middle magnified 1 times/ });
  await expect(closer).toBeVisible();
  await page.getByRole("slider", { name: "The middle, magnified" }).press("End");
  await expect(page.getByRole("img", { name: /^The middle magnified 10000 times/ })).toBeVisible();
  await expectChange(page.getByRole("img", { name: /^The function of Table 1/ }), () =>
    page.getByRole("slider", { name: "Feature points" }).press("ArrowLeft"),
  );
});

test("Table 2 is voted for, stopped and voted for again", async ({ page }) => {
  test.setTimeout(120_000);
  await open(page, "ct2");
  await page.getByRole("button", { name: "Stop" }).click();
  await expect(page.getByText(/^stopped after/).first()).toBeVisible();
  await page.getByRole("button", { name: "Count again" }).click();
  const here = page.getByRole("table", { name: /most popular maps here/ });
  await expect(here.getByRole("row")).toHaveCount(11, { timeout: 90_000 });
  // Both maps of Table 1 come before everything else, in either order.
  for (const name of ["T₁ itself", "T₂ itself"]) {
    const row = here.getByRole("row").filter({ hasText: name });
    await expect(row.getByRole("rowheader")).toHaveText(/^#[12]$/);
  }
  const printed = page.getByRole("table", { name: "Table 2, as printed" });
  for (const cell of await printed.locator("tbody tr td:last-child").all()) {
    await expect(cell).toHaveText(/^#\d+, [\d ]+ hits$/);
  }
});

test("Figure 3 turns by keys and by dragging, and shows its shadows", async ({ page }) => {
  await open(page, "c3");
  const curve = page.getByRole("img", { name: /^The space curve/ });
  await expectChange(curve, () => page.getByRole("slider", { name: "Turn" }).press("ArrowRight"));
  await expectChange(curve, () => page.getByRole("slider", { name: "Tilt" }).press("PageUp"));
  await expectChange(curve, () => page.getByRole("button", { name: "From above" }).click());
  await expect(curve).toHaveAccessibleName(/the function of Figure 4$/);
  await expectChange(curve, async () => {
    const box = await curve.boundingBox();
    if (!box) throw new Error("the curve is not on the page");
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + 80, box.y + box.height / 2 - 50, { steps: 4 });
    await page.mouse.up();
  });
});

test("Figure 4 fits the whole into its middle only", async ({ page }) => {
  await open(page, "c4");
  const graph = page.getByRole("img", { name: /^The height of the curve/ });
  await expect(graph).toHaveAccessibleName(/left third .* misses by 1\d\.\d%/);
  await page.getByRole("radio", { name: "Middle" }).check();
  await expect(graph).toHaveAccessibleName(/middle third .* it is the same$/);
  await expectChange(graph, () => page.getByRole("slider", { name: "Height of corner B" }).press("End"));
});

test("Figure 5 steps through its clusters", async ({ page }) => {
  test.setTimeout(120_000);
  await open(page, "c5");
  const slider = page.getByRole("slider", { name: "Cluster" });
  await expect(slider).toHaveAttribute("max", "100", { timeout: 90_000 });
  const image = page.getByRole("img", { name: /moved by the map of cluster 1$/ });
  await expect(image).toBeVisible();
  await expectChange(page.getByRole("img", { name: /^The clusters over a and c/ }), () =>
    slider.press("ArrowRight"),
  );
  await expect(page.getByRole("img", { name: /moved by the map of cluster 2$/ })).toBeVisible();
  await expectChange(page.getByRole("img", { name: /moved by the map of cluster 2$/ }), () =>
    page.getByRole("switch", { name: "Refine it by least squares" }).check(),
  );
  await expect(page.getByText(/of the spread lies along two directions/)).toBeVisible();
});

test("Figure 6 is made of seven maps and of eleven", async ({ page }) => {
  await open(page, "c6");
  const errors = page.getByRole("table", { name: "Distance from the original" });
  await expect(errors.getByRole("row", { name: /fractions/ })).toHaveText(/0\.0820\s*0\.000157/);
  await expect(errors.getByRole("row", { name: /three digits/ })).toHaveText(/0\.000183/);
  const graph = page.getByRole("img", { name: /^The function of 7 maps/ });
  await expectChange(graph, () => page.getByRole("slider", { name: "Piece" }).press("ArrowRight"));
  await page.getByRole("radio", { name: /11, an RFIF/ }).check();
  await expect(page.getByRole("img", { name: /^The function of 11 maps/ })).toHaveAccessibleName(
    /0, 7\/54, 1\/6, 13\/54, 5\/18, 1\/3, 4\/9, 1\/2, 2\/3, 41\/54, 47\/54, 1$/,
  );
  await expect(page.getByRole("table", { name: /as an RFIF/ }).getByRole("row")).toHaveCount(12);
});

test("Figure 7 ties the ends of copies, and fits its own curve", async ({ page }) => {
  test.setTimeout(120_000);
  await open(page, "c7");
  await stopFit(page);
  const fit = page.getByRole("img", { name: /^The paper’s fit with 29 maps/ });
  await expect(fit).toHaveAccessibleName(/gaps up to 0\.\d+%/, { timeout: 60_000 });
  await page.getByRole("switch", { name: "Tie the ends of copies" }).check();
  await expect(fit).toHaveAccessibleName(/ends tied: no gaps$/, { timeout: 60_000 });
  await page.getByRole("switch", { name: "Tie the ends of copies" }).uncheck();
  const closer = page.getByRole("img", { name: /^Where two of 29 copies should meet/ });
  await expect(closer).toHaveAccessibleName(/a gap of/, { timeout: 60_000 });
  await expectChange(closer, () => page.getByRole("slider", { name: "Gap" }).press("ArrowRight"));
  const errors = page.getByRole("table", { name: "Errors in percent of the diagonal" });
  await expect(errors.getByRole("row", { name: /^Plain polyline/ })).toHaveText(/290\s*0\.1\d\d/, {
    timeout: 60_000,
  });
});

test("graphs open in the tool that fits", async ({ page }) => {
  for (const figure of ["c1", "c6"]) {
    await open(page, figure);
    await page.getByRole("link", { name: "Open in the Fit tool" }).click();
    await expect.poll(() => page.evaluate(() => window.frond?.scene().tool)).toBe("fit");
    await expect.poll(() => page.evaluate(() => window.frond?.scene().fit?.mode)).toBe("graph");
    await expect(page.getByRole("alert")).toHaveCount(0);
  }
});
