import type { Locator, Page } from "@playwright/test";
import { look, openFigure } from "./figure-pages";
import { expect, test } from "./fixture";

async function expectChange(picture: Locator, act: () => Promise<unknown>): Promise<void> {
  const before = await look(picture);
  await act();
  await expect.poll(async () => (await look(picture)).hash).not.toBe(before.hash);
  expect((await look(picture)).lit).toBeGreaterThan(0.001);
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

test("figures are found under the numbers of the paper too", async ({ page }) => {
  for (const [id, title] of [
    ["ct1", "A mountain range of ten numbers"],
    ["ct3", "Seven maps, or eleven"],
  ] as const) {
    await page.goto(`./#figures/${id}`);
    await expect(page.getByRole("heading", { level: 1, name: title })).toBeVisible();
  }
});

test("Figure 1 is moved by mouse, keys, sliders and numbers", async ({ page }) => {
  await openFigure(page, "c1");
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
  await openFigure(page, "c2");
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
  await openFigure(page, "ct2");
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
  await openFigure(page, "c3");
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
  await openFigure(page, "c4");
  const graph = page.getByRole("img", { name: /^The height of the curve/ });
  await expect(graph).toHaveAccessibleName(/left third .* misses by 1\d\.\d%/);
  await page.getByRole("radio", { name: "Middle" }).check();
  await expect(graph).toHaveAccessibleName(/middle third .* it is the same$/);
  await expectChange(graph, () => page.getByRole("slider", { name: "Height of corner B" }).press("End"));
});

test("Figure 5 steps through its clusters", async ({ page }) => {
  test.setTimeout(120_000);
  await openFigure(page, "c5");
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
  await openFigure(page, "c6");
  const errors = page.getByRole("table", { name: "Distance from the original" });
  await expect(errors.getByRole("row", { name: /fractions/ })).toHaveText(/0\.0820\s*0\.000157/);
  await expect(errors.getByRole("row", { name: /three digits/ })).toHaveText(/0\.000183/);
  const graph = page.getByRole("img", { name: /^The function of 7 maps/ });
  await expectChange(graph, () => page.getByRole("slider", { name: "Piece" }).press("ArrowRight"));
  await page.getByRole("radio", { name: "7, as printed" }).check();
  await expect(
    page.getByRole("img", { name: /^The distance of the seven maps .* 0\.0886 at most$/ }),
  ).toBeVisible();
  await page.getByRole("radio", { name: /11, an RFIF/ }).check();
  await expect(page.getByRole("img", { name: /^The function of 11 maps/ })).toHaveAccessibleName(
    /0, 7\/54, 1\/6, 13\/54, 5\/18, 1\/3, 4\/9, 1\/2, 2\/3, 41\/54, 47\/54, 1$/,
  );
  await expect(page.getByRole("table", { name: /as an RFIF/ }).getByRole("row")).toHaveCount(12);
});

test("Figure 7 ties the ends of copies, and fits its own curve", async ({ page }) => {
  test.setTimeout(120_000);
  await openFigure(page, "c7");
  await stopFit(page);
  const fit = page.getByRole("img", { name: /^The paper’s fit with 29 maps/ });
  await expect(fit).toHaveAccessibleName(/gaps up to \d+\.\d+%/, { timeout: 60_000 });
  await page.getByRole("switch", { name: "Tie the ends of copies" }).check();
  await expect(fit).toHaveAccessibleName(/ends tied: no gaps$/, { timeout: 60_000 });
  await page.getByRole("switch", { name: "Tie the ends of copies" }).uncheck();
  const closer = page.getByRole("img", { name: /^Where two of 29 copies should meet/ });
  await expect(closer).toHaveAccessibleName(/a gap of/, { timeout: 60_000 });
  await expectChange(closer, () => page.getByRole("slider", { name: "Gap" }).press("ArrowRight"));
  const errors = page.getByRole("table", { name: "Errors in percent of the diagonal" });
  await expect(errors.getByRole("row", { name: /^Polyline, split/ })).toHaveText(/290\s*0\.0\d\d/, {
    timeout: 60_000,
  });
  // Eight numbers a map: 29 of them are 232.
  await page.getByRole("switch", { name: /eq 8/ }).check();
  await expect(page.getByRole("radio", { name: "232 numbers" })).toBeChecked();
  await expect(errors.getByRole("row", { name: /^The paper, 29 maps/ })).toHaveText(/232/, {
    timeout: 60_000,
  });
});
