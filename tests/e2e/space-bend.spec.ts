import type { Page } from "@playwright/test";
import { expect, test } from "./fixture";

// A picture of space costs by its pixels.
test.use({ viewport: { width: 780, height: 480 } });

const complete = (page: Page) =>
  expect(page.getByTestId("space-status")).toHaveText("Complete picture", { timeout: 120_000 });
const packed = async (studio: { scene(): Promise<{ space?: { packed: string } }> }) =>
  (await studio.scene()).space?.packed ?? "";

test("a lattice bends a shape by key, hand and number, and undo makes it straight again", async ({
  studio,
  page,
}) => {
  await studio.open("tool=space&space=o:tetrahedron");
  await complete(page);
  const straight = await studio.look();
  const start = await packed(studio);
  await page.getByRole("radio", { name: "Deform", exact: true }).check({ force: true });
  await page.getByRole("button", { name: "Deform it" }).click();
  const handle = page.getByRole("button", { name: /^Handle 3, 3, 3,/ });
  await expect(page.getByRole("button", { name: /^Handle \d, \d, \d,/ })).toHaveCount(27);
  await complete(page);
  const bent = await studio.look();
  expect(bent.hash).not.toBe(straight.hash);
  const first = await packed(studio);
  expect(first).toMatch(/^o:tetrahedron~b3,3,3,0,4,0.5,0;26,/);
  await handle.focus();
  await page.keyboard.press("ArrowUp");
  expect(await packed(studio)).not.toBe(first);
  const box = await handle.boundingBox();
  if (!box) throw new Error("The handle has no place.");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 60, y + 30, { steps: 4 });
  await page.mouse.up();
  await complete(page);
  const dragged = await packed(studio);
  expect((await studio.look()).hash).not.toBe(bent.hash);
  await page.getByLabel("Moved along x").fill("0.25");
  await page.keyboard.press("Enter");
  expect(await packed(studio)).toMatch(/;26,0.25,/);
  const undo = page.getByRole("button", { name: "Undo", exact: true });
  await undo.click();
  expect(await packed(studio)).toBe(dragged);
  for (let step = 0; step < 3; step++) await undo.click();
  await expect(undo).toBeDisabled();
  // The view went where all handles are seen: to look is nothing to undo.
  expect(await packed(studio)).toBe(start);
});

test("a lattice goes from key to key, and the panel says whether the bent shape holds", async ({
  studio,
  page,
}) => {
  await studio.open(
    "tool=space&space=o:tetrahedron~b2,2,2,0,3,0.5,0/time:4,0,straight/k:0,even~b0,8/k:4,even~b0,8;7,0,0,0.8",
  );
  await complete(page);
  const rest = await studio.look();
  await page.getByRole("radio", { name: "Deform", exact: true }).check({ force: true });
  await expect(page.getByTestId("bent-verdict")).toContainText("In one piece, proved", { timeout: 30_000 });
  await page.getByRole("slider", { name: /time/i }).first().focus();
  await page.keyboard.press("End");
  await expect(page.getByTestId("bent-verdict")).toContainText("In one piece");
  await expect(page.getByTestId("bent-verdict")).toContainText("as without the deformation");
  await complete(page);
  expect((await studio.look()).hash).not.toBe(rest.hash);
  // A pull there changes that key alone.
  await page.getByRole("button", { name: /^Handle 2, 2, 2,/ }).focus();
  await page.getByLabel("Moved along x").fill("0.25");
  await page.keyboard.press("Enter");
  expect(await packed(studio)).toMatch(/k:0,even~b0,8\/k:4,even~b0,8;7,0\.25,0,0\.8/);
});
