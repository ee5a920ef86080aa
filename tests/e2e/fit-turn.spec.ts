import { apart, FitTool, file, GREEN, inLeaf, PAPER } from "./fit-tool";
import { expect, test } from "./fixture";
import { png } from "./png";

/** A leaf at the left of a wide picture. */
const lying = png(420, 240, (x, y) => (inLeaf(x, y, 115, 120, 105) ? GREEN : PAPER));

test("a photograph is turned where the leaf is cut out, and what was painted goes along", async ({
  page,
}) => {
  const tool = new FitTool(page);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await tool.openFew(12);
  await tool.input.setInputFiles(file(lying, "leaf.png"));
  await expect(tool.status).toHaveText(/^Cut out: one part$/);
  const source = page.getByTestId("source");
  await expect(source).toContainText("420 × 240 pixels");
  const box = await tool.stage.boundingBox();
  if (!box) throw new Error("there is no stage");
  const greenAt = async (x: number, y: number, width: number, height: number) => {
    const at = await tool.place(x, y, width, height);
    return apart(await tool.colourAt((at.x - box.x) / box.width, (at.y - box.y) / box.height), GREEN);
  };
  // A stroke through the middle takes it away.
  await page.getByRole("radio", { name: "Not leaf" }).check({ force: true });
  await page.getByRole("switch", { name: "Do not spread" }).check({ force: true });
  const at = await tool.place(115, 120, 420, 240);
  await page.mouse.move(at.x - 20, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x + 20, at.y, { steps: 6 });
  await page.mouse.up();
  await page.mouse.move(box.x + 5, box.y + 5);
  await expect.poll(() => greenAt(115, 120, 420, 240)).toBeGreaterThan(60);

  await page.getByRole("button", { name: "Right", exact: true }).click();
  await expect(source).toContainText("240 × 420 pixels");
  // What was at the left is above, with its stroke.
  await expect.poll(() => greenAt(120, 115, 240, 420)).toBeGreaterThan(60);
  await expect.poll(() => greenAt(120, 65, 240, 420)).toBeLessThan(12);
  await page.getByRole("button", { name: "Upside down" }).click();
  await expect.poll(() => greenAt(120, 355, 240, 420)).toBeLessThan(12);
  await page.getByRole("button", { name: "Undo stroke" }).click();
  await expect.poll(() => greenAt(120, 305, 240, 420)).toBeLessThan(12);
  await page.getByRole("button", { name: "Fit this outline" }).click();
  await tool.fitted();
});
