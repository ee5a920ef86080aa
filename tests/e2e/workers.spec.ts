import { expect, test } from "./fixture";
import type { Studio } from "./studio";

test.use({ alone: true, proofs: true });

/** Collects what the progress bar of the locus says, from the start of the page. */
async function watchProgress({ page }: Studio): Promise<() => Promise<number[]>> {
  await page.addInitScript(() => {
    const seen: number[] = [];
    Object.assign(window, { seen });
    new MutationObserver(() => {
      const bar = document.querySelector(".locus-progress");
      const value = Number(bar?.getAttribute("aria-valuenow") ?? Number.NaN);
      if (!Number.isNaN(value) && value !== seen.at(-1)) seen.push(value);
    }).observe(document, { subtree: true, childList: true, attributes: true });
  });
  return () => page.evaluate(() => (window as unknown as { seen: number[] }).seen);
}

async function expectWhole({ page, time }: Studio): Promise<void> {
  await expect(page.locator(".locus-progress")).toHaveCount(0);
  const place = page.getByRole("slider", { name: "Position on the path" });
  await time.press("Home");
  await expect(place).toHaveAttribute("aria-valuetext", /^0% of the path, (in one piece|no gap seen)/);
  await time.press("End");
  await expect(place).toHaveAttribute("aria-valuetext", /^100% of the path, (in one piece|no gap seen)/);
}

test("the locus comes coarse to fine, and holds both ends", async ({ studio }) => {
  const progress = await watchProgress(studio);
  await studio.open("a=dragon-3&b=gasket");
  await studio.idle();
  const seen = await progress();
  expect(seen.length).toBeGreaterThan(1);
  expect(seen).toEqual([...seen].sort((p, q) => p - q));
  await expectWhole(studio);
});

test("what holds as far as can be seen is proved at rest, and anew after a change", async ({
  studio,
  page,
}) => {
  const legend = page.getByRole("list", { name: "Legend" });
  await studio.open("a=dragon-3&b=gasket&path=straight&t=0.5");
  await expect(legend).toContainText(/proved \(9\d% of the pale area\)/, { timeout: 30_000 });
  await page.getByRole("button", { name: "Swap A and B" }).click();
  await expect(legend).toContainText(/proved \([1-4]?\d% of the pale area\)/);
  await expect(legend).toContainText(/proved \(9\d% of the pale area\)/, { timeout: 30_000 });
});

test("a worker that dies in the middle is replaced, and nothing is missing", async ({ studio, page }) => {
  await studio.open("a=gasket&b=gasket");
  await studio.idle();
  await page.evaluate(() => {
    location.hash = "a=dragon-3&b=gasket";
  });
  const bar = page.locator(".locus-progress");
  await bar.waitFor({ state: "attached" });
  for (let deaths = 0; deaths < 2; deaths++) await page.evaluate(() => window.frond?.killWorker());
  await studio.idle();
  await expectWhole(studio);
  expect(await studio.said()).toEqual([]);
  // Nothing was left out: the same picture of the field as without deaths.
  const field = () =>
    page.locator("canvas.locus-field").evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());
  const mended = await field();
  await page.reload();
  await studio.time.waitFor();
  await studio.idle();
  expect(await field()).toBe(mended);
});

test("a change in the middle replaces what was under way", async ({ studio, page }) => {
  await studio.open("a=fern&b=maple");
  for (const link of ["a=levy&b=twindragon", "a=koch&b=gasket", "a=dragon-3&b=gasket"]) {
    await page.evaluate((fragment) => {
      location.hash = fragment;
    }, link);
  }
  await studio.idle();
  await expectWhole(studio);
  expect((await studio.scene()).a.preset).toBe("dragon-3");
});

test("without workers everything works", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&path=straight&t=0.5", "?workers=0");
  await expect.poll(() => studio.said()).toEqual([expect.stringContaining("Running without workers")]);
  await studio.idle();
  await expect(page.getByText("no workers")).toBeVisible();
  await expect(studio.verdict).toHaveText(/^In pieces/);
  await expectWhole(studio);
  expect((await studio.look()).lit).toBeGreaterThan(1000);
});

test("where workers cannot be started everything works", async ({ studio, page }) => {
  await page.addInitScript(() => {
    window.Worker = class {
      constructor() {
        throw new Error("forbidden here");
      }
    } as unknown as typeof Worker;
  });
  await studio.open("a=dragon-3&b=gasket&path=straight&t=0.5");
  await studio.idle();
  await expect(studio.verdict).toHaveText(/^In pieces/);
  await expectWhole(studio);
});
