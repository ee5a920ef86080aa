import { expect, test } from "./fixture";

test("a point is chosen and led by a thumb", async ({ studio, page }) => {
  await studio.open("a=gasket&b=gasket&path=straight");
  await page.getByRole("button", { name: "Follow a point" }).tap();
  const panel = page.getByRole("region", { name: "Follow a point" });
  for (const button of await panel.getByRole("button").all()) {
    const box = await button.boundingBox();
    expect(box?.height, (await button.textContent()) ?? "").toBeGreaterThanOrEqual(44);
  }
  const first = await page.getByTestId("orbit-words").textContent();
  const stage = await page.locator(".picture").first().boundingBox();
  if (!stage) throw new Error("no stage");
  await page.touchscreen.tap(stage.x + stage.width / 2, stage.y + 0.3 * stage.height);
  await expect(page.getByTestId("orbit-words")).not.toHaveText(first ?? "");
  await panel.getByRole("button", { name: "Apply map 2" }).tap();
  await expect(page.getByTestId("orbit-address")).toHaveText("2 …");
  // Of the game a piece is thrown to by a tap on it.
  await page.getByRole("radio", { name: "Reach a cell" }).check();
  await page.touchscreen.tap(stage.x + stage.width / 2, stage.y + 0.3 * stage.height);
  await expect(page.getByTestId("orbit-thrown")).toHaveText("3");
});
