import type { Page } from "@playwright/test";
import { expectClean } from "./axe";
import { apart, FitTool, file, GREEN, leafPicture } from "./fit-tool";
import { expect, test } from "./fixture";

test.use({ alone: true });

const shelf = (page: Page) => page.getByRole("region", { name: "Your fits" });
const row = (page: Page, name: string) => shelf(page).getByRole("listitem").filter({ hasText: name });
const card = (page: Page) => page.getByTestId("source").locator("span").first();

async function more(page: Page, name: string, item: string): Promise<void> {
  await page.getByRole("button", { name: `More for ${name}` }).click();
  await page.getByRole("menuitem", { name: item, exact: true }).click();
}

/** A fit of the leaf on paper, kept. */
async function keepLeaf(tool: FitTool, page: Page): Promise<void> {
  await tool.openFew(24);
  await tool.input.setInputFiles(file(leafPicture, "leaf.png"));
  await page.getByRole("button", { name: "Fit this outline" }).click();
  await tool.fitted();
  await shelf(page).getByRole("button", { name: "Save this fit" }).click();
  await expect(row(page, "leaf")).toContainText(/error · \d+ numbers · \d+ bytes/);
  await expect(shelf(page).getByRole("button", { name: "Saved" })).toBeDisabled();
}

test("a fit is kept, opened again without fitting anew, named, pinned, removed and put back", async ({
  page,
}) => {
  const tool = new FitTool(page);
  await keepLeaf(tool, page);
  const made = (await tool.scene()).fit?.curve?.curve;
  const rms = await page.getByTestId("rms").textContent();

  await test.step("another one takes its place, and it comes back with its outline", async () => {
    await page.getByRole("button", { name: "Oak leaf" }).click();
    await expect(card(page)).toHaveText("Oak leaf");
    await tool.fitted();
    await shelf(page).getByRole("button", { name: "Open leaf" }).click();
    await expect(card(page)).toHaveText("leaf");
    await tool.fitted();
    expect((await tool.scene()).fit?.curve?.curve).toEqual(made);
    await expect(page.getByTestId("rms")).toHaveText(rms ?? "");
    await expect(page.getByTestId("source")).toContainText(/with its outline of [\d,]+ points/);
  });

  await test.step("and goes again", async () => {
    await page.getByRole("button", { name: "Undo", exact: true }).click();
    await expect(card(page)).toHaveText("Oak leaf");
    await page.getByRole("button", { name: "Redo", exact: true }).click();
    await expect(card(page)).toHaveText("leaf");
    await tool.fitted();
    expect((await tool.scene()).fit?.curve?.curve).toEqual(made);
  });

  await test.step("it is there after a reload", async () => {
    await tool.openFew(24);
    await tool.fitted();
    await page.getByRole("button", { name: "Your fits (1)" }).click();
    await expect(shelf(page)).toBeFocused();
    await expect(row(page, "leaf")).toBeInViewport();
  });

  await more(page, "leaf", "Rename");
  await page.getByRole("textbox", { name: "Name of leaf" }).fill("From the garden");
  await page.keyboard.press("Enter");
  await more(page, "From the garden", "Pin");
  await expect(row(page, "From the garden")).toContainText("pinned");
  await expectClean(page);
  await more(page, "From the garden", "Remove");
  await expect(shelf(page).getByRole("listitem")).toHaveCount(0);
  await page.locator(".toasts").getByRole("button", { name: "Undo" }).click();
  await expect(row(page, "From the garden")).toContainText("pinned");

  await test.step("it is used as B", async () => {
    await more(page, "From the garden", "Use as B");
    await expect(page.getByRole("slider", { name: "Time", exact: true })).toBeVisible();
    const { curves } = await tool.scene();
    expect(curves?.b.name).toBe("From the garden");
    expect(curves?.b.curve.knots.length).toBe(made?.knots.length);
  });
});

test("the photograph of a fit goes along, cut out, and is bent by the grid", async ({ studio, page }) => {
  const tool = new FitTool(page);
  await keepLeaf(tool, page);
  await tool.openFew(24);
  await tool.fitted();
  await more(page, "leaf", "Deform its photo");
  const picture = page.getByRole("region", { name: "Your picture" });
  await expect(picture.locator(".subject-name", { hasText: "leaf" })).toBeVisible();
  expect((await tool.scene()).deform?.subject).toBe("picture");
  const { lit, box, colours } = await studio.look();
  const [left, top, right, bottom] = box;
  const all = (right - left) * (bottom - top);
  expect(lit).toBeGreaterThan(0.3 * all);
  // What is around the leaf is not there.
  expect(lit).toBeLessThan(0.8 * all);
  const [red = 0, green = 0, blue = 0] = [1, 3, 5].map((i) =>
    Number.parseInt(colours[0]?.slice(i, i + 2) ?? "", 16),
  );
  expect(apart([red, green, blue], GREEN)).toBeLessThan(30);
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  await expect.poll(async () => (await tool.scene()).deform).toBeUndefined();
});

test("where the browser keeps nothing, the shelf says so, and the fit stays", async ({ page }) => {
  await page.addInitScript(() => Object.defineProperty(window, "indexedDB", { value: undefined }));
  const tool = new FitTool(page);
  await tool.openFew(24);
  await tool.fitted();
  await shelf(page).getByRole("button", { name: "Save this fit" }).click();
  await expect(shelf(page).getByRole("status")).toContainText("private window");
  await expect(shelf(page).getByRole("button", { name: "Save this fit" })).toBeEnabled();
  await tool.fitted();
});
