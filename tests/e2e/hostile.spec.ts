import { expect, test } from "./fixture";

const zeros = (count: number) => `a=maps:${Array(count).fill("0.1,0,0,0.1,0,0").join(";")}`;

/** Damaged, huge and malicious fragments. Each opens what Frond begins with, and says so. */
const HOSTILE: Record<string, string> = {
  "nobody's shape": "a=nobody",
  "no maps": "a=maps:",
  "too few numbers": "a=maps:1,2,3",
  "not a number": "a=maps:NaN,0,0,0,0,0",
  infinite: "a=maps:1e999,0,0,0,0,0",
  "beyond squaring": "a=maps:1e200,0,0,0,0,0",
  "no attractor": "b=maps:0.5,0,0,0.5,0,0;2,0,0,2,0,0",
  "nearly no attractor": "a=maps:1,0,0,1,0,0",
  "65 maps": zeros(65),
  "65 way points": `path=drawn:${Array(65).fill("0,0").join(";")}`,
  "far away": "path=drawn:1e300,0",
  "no time": "t=NaN",
  "an impossible match": "match=1,1,2",
  "a huge match": "match=99999999999999999999",
  "too many turns": "turns=1,2,99",
  "no view": "view=0,0,0",
  "a tag": "colour=<script>window.hacked=1</script>",
  "half a percent sign": "a=%E0%A4%A&b=%",
  "a prototype": "a=__proto__&b=constructor",
  "version 0": "v=0",
  "70 kB": `a=${"maps:".repeat(14_000)}`,
  "a million maps": `a=maps:${";".repeat(1_000_000)}`,
};

test("hostile fragments open the default and say why", async ({ studio, page }) => {
  await studio.open();
  const { path: _, ...start } = await studio.scene();
  for (const [what, fragment] of Object.entries(HOSTILE)) {
    await test.step(what, async () => {
      const { words, scene } = await page.evaluate(async (text) => {
        location.hash = text;
        const alert = () => document.querySelector(".toasts [role=alert]");
        while (!alert()) await new Promise(requestAnimationFrame);
        const words = alert()?.textContent;
        alert()?.querySelector<HTMLElement>("button[aria-label=Dismiss]")?.click();
        while (alert()) await new Promise(requestAnimationFrame);
        return { words, scene: window.frond?.scene() };
      }, fragment);
      expect(words).toContain("Frond shows what it begins with instead.");
      expect(scene).toMatchObject(start);
    });
  }
  expect((await studio.look()).lit).toBeGreaterThan(1000);
  expect(await page.evaluate(() => "hacked" in window)).toBe(false);
});

for (const what of ["a million maps", "a tag"]) {
  test(`a page that begins with ${what} begins all the same`, async ({ studio, page }) => {
    await studio.open(HOSTILE[what]);
    await expect(studio.alerts).toHaveCount(1);
    expect((await studio.scene()).a.preset).toBe("dragon-3");
    expect((await studio.look()).lit).toBeGreaterThan(1000);
    // The address heals with the first change.
    await studio.time.press("ArrowRight");
    await expect(page).toHaveURL(/#v=1&a=dragon-3&b=gasket/);
  });
}

test("names are text, whatever they say", async ({ studio, page }) => {
  const name = encodeURIComponent('<img src=x onerror="window.hacked=1">');
  const maps = "0.45,0,0,0.5,0,0;0.5,0,0,0.5,0.5,0;0.5,0,0,0.5,0.25,0.433";
  await studio.open(`a=maps:${maps}&a-name=${name}&b=gasket`);
  await expect(page.getByRole("button", { name: /^Shape A: <img src=x/ })).toBeVisible();
  await page.getByRole("button", { name: "Edit the maps of A" }).click();
  await expect(page.getByRole("heading", { name: /<img src=x/ })).toBeVisible();
  expect(await page.evaluate(() => "hacked" in window)).toBe(false);
});

test("links of later versions show what is understood", async ({ studio }) => {
  await studio.open("v=2&a=koch&b=gasket&weather=rain");
  await expect(studio.alerts).toContainText("a later version of Frond");
  expect((await studio.scene()).a.preset).toBe("koch");
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
