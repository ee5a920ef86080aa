import { Finger } from "./finger";
import { apart, FitTool, file, GREEN, leafPicture } from "./fit-tool";
import { expect, test } from "./fixture";

test("the outline is on top, its slider below it, and nothing is wider than the phone", async ({ page }) => {
  const tool = new FitTool(page);
  await tool.openFew(24);
  await tool.fitted();
  const width = await page.evaluate(() => document.documentElement.scrollWidth);
  expect(width).toBe(390);
  const side = await page.locator(".side").evaluate((element) => element.scrollWidth - element.clientWidth);
  expect(side).toBe(0);
  const stage = await tool.stage.boundingBox();
  const slider = await page.getByRole("slider", { name: "Numbers in the fit" }).boundingBox();
  if (!stage || !slider) throw new Error("something is missing");
  expect(stage.height).toBeGreaterThan(200);
  expect(slider.y).toBeGreaterThanOrEqual(stage.y + stage.height - 10);
  expect(slider.width).toBeGreaterThan(180);
  expect(slider.height).toBeGreaterThanOrEqual(34);
  for (const name of ["Choose a photo or outline", "Use as A", "Use as B", "Deform it"]) {
    const box = await page.getByRole("button", { name }).boundingBox();
    expect(box?.height).toBeGreaterThanOrEqual(44);
  }
});

test("a finger pans, two enlarge, and one with a brush mends the mask", async ({ page }) => {
  const tool = new FitTool(page);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await tool.openFew(12);
  await tool.input.setInputFiles(file(leafPicture, "leaf.png"));
  await expect(tool.status).toHaveText(/^Cut out: one part$/);
  const finger = await Finger.of(page);
  const box = await tool.stage.boundingBox();
  if (!box) throw new Error("there is no stage");
  const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  await finger.pinch(middle, 60, 120);
  await expect(tool.stage.locator("+ .stage-foot .readout")).toHaveText(/×2\.0/);
  await page.getByRole("button", { name: "Fit to the stage" }).tap();
  const at = await tool.place(180, 190, 360, 400);
  const seen = () => tool.colourAt((at.x - box.x) / box.width, (at.y - box.y) / box.height);
  await expect.poll(async () => apart(await seen(), GREEN)).toBeLessThan(12);
  await expect(page.getByRole("button", { name: "Fit this outline" })).toBeInViewport();
  await page.getByRole("radio", { name: "Not leaf" }).check({ force: true });
  await page.getByRole("switch", { name: "Do not spread" }).check({ force: true });
  await finger.drag({ x: at.x - 20, y: at.y }, { x: at.x + 20, y: at.y });
  await expect(page.getByRole("button", { name: "Undo stroke" })).toBeEnabled();
  await page.getByRole("radio", { name: "Move", exact: true }).check({ force: true });
  await expect.poll(async () => apart(await seen(), GREEN)).toBeGreaterThan(60);
});
