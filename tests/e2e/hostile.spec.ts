import { expect, test } from "./fixture";

test("a page that begins with a hostile link begins all the same, and the address heals", async ({
  studio,
  page,
}) => {
  await studio.open(`a=maps:${";".repeat(1_000_000)}`);
  await expect(studio.alerts).toHaveCount(1);
  expect((await studio.scene()).a.preset).toBe("dragon-3");
  expect((await studio.look()).lit).toBeGreaterThan(1000);
  await studio.time.press("ArrowRight");
  await expect(page).toHaveURL(/#v=1&check=[^&]+&a=dragon-3&b=gasket/);
});

test("names are text, whatever they say", async ({ studio, page }) => {
  const name = encodeURIComponent('<img src=x onerror="window.hacked=1">');
  const maps = "0.45,0,0,0.5,0,0;0.5,0,0,0.5,0.5,0;0.5,0,0,0.5,0.25,0.433";
  await studio.open(`a=maps:${maps}&a-name=${name}&b=gasket`);
  await expect(page.getByRole("button", { name: /^Shape A: <img src=x/ })).toBeVisible();
  await page.getByRole("button", { name: "Edit the maps of A" }).click();
  await expect(page.getByRole("textbox", { name: "Name of shape A" })).toHaveValue(/^<img src=x/);
  expect(await page.evaluate(() => "hacked" in window)).toBe(false);
});

test("shapes at the edge of what contracts neither hang nor crash", async ({ studio, page }) => {
  await studio.open("a=gasket&b=gasket");
  for (const link of [
    "a=maps:0.999999,0,0,0.999999,0,0;0.999999,0,0,0.999999,0,1&b=gasket",
    "a=maps:0.5,1e5,0,0.5,0,0;0.5,0,0,0.5,1,0&b=gasket&path=straight&t=0.5",
    "a=maps:0,0,0,0,0,0&b=maps:0,0,0,0,1e5,-1e5&t=0.5",
    "a=maps:1e-300,0,0,1e-300,0,0;1e-300,0,0,1e-300,1e-300,0&b=dust",
  ]) {
    await test.step(link, async () => {
      await page.evaluate((fragment) => {
        location.hash = fragment;
      }, link);
      await expect.poll(async () => (await studio.scene()).a.preset).toBeUndefined();
      await studio.idle();
      await expect(studio.verdict).not.toHaveText(/Looking/);
      await expect(studio.alerts).toHaveCount(0);
    });
  }
});
