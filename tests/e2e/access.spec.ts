import { expectClean } from "./axe";
import { expect, test } from "./fixture";

test("axe finds nothing", async ({ studio, page }) => {
  // Without motion, so that no colour is half-way between two.
  await page.emulateMedia({ reducedMotion: "reduce" });
  await studio.open("a=dragon-3&b=gasket&path=drawn:0.2,0.8&t=0.5");
  await studio.idle();
  await test.step("landmarks, one title, and a name for every control", async () => {
    await expect(page.getByRole("main")).toHaveCount(1);
    await expect(page.getByRole("banner")).toHaveCount(1);
    await expect(page.getByRole("heading", { level: 1 })).toHaveCount(1);
    await expect(page.getByRole("region", { name: "Picture" })).toBeVisible();
    await expect(page.getByRole("complementary", { name: "Shapes and path" })).toBeVisible();
    await expect(page.locator("html")).toHaveAttribute("lang", "en");
    for (const control of await page.getByRole("button").or(page.getByRole("slider")).all()) {
      await expect(control).toHaveAccessibleName(/\w/);
    }
  });
  await test.step("morph", () => expectClean(page));
  await test.step("a waypoint and a bad number", async () => {
    await studio.way(1).focus();
    const u = page.getByRole("spinbutton", { name: "turn and stretch, u" });
    await u.fill("many");
    await u.press("Enter");
    await page.getByText("Which map becomes which").click();
    await page.getByRole("switch", { name: /side by side/ }).check();
    await expectClean(page);
    await page.getByRole("switch", { name: /side by side/ }).uncheck();
  });
  await test.step("gallery", async () => {
    await page.getByRole("button", { name: /^Shape A: / }).click();
    await expectClean(page);
    await page.keyboard.press("Escape");
  });
  await test.step("shortcuts", async () => {
    await page.locator("body").press("?");
    await expectClean(page);
    await page.keyboard.press("Escape");
  });
  await test.step("editor", async () => {
    await page.getByRole("button", { name: "Edit the maps of B" }).click();
    await expectClean(page);
  });
  await test.step("sharing and a menu", async () => {
    await page.getByRole("button", { name: "Share", exact: true }).click();
    await page.getByRole("dialog", { name: "Share" }).getByRole("img").waitFor();
    await expectClean(page);
    await page.keyboard.press("Escape");
    await page.getByRole("button", { name: "More for shape B" }).click();
    await expectClean(page);
  });
});

test("what changes is said aloud", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&path=straight");
  await studio.idle();
  const said = page.locator("p[aria-live=polite]");
  await expect(said).toBeEmpty();
  await studio.time.focus();
  for (let i = 0; i < 5; i++) await studio.time.press("PageUp");
  await expect(said).toHaveText(/^In pieces, gap [\d.]+%, by Frond’s own bounds$/);
  await studio.time.press("End");
  await expect(said).toHaveText(/^(In one piece, proved|No gap seenchecked to 1\/600 of its size)$/);
  await studio.way(1).count();
  await page.getByRole("button", { name: "Swap A and B" }).click();
  await expect(said).toHaveText("Swapped: from Gasket to Dragon of three.");
});
