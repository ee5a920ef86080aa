// The page itself, in Chromium: how soon the coarse locus is on screen after a change, how long the whole one takes,
// and what a second worker is worth.
import { chromium } from "@playwright/test";

const address = process.env["FROND_URL"] ?? "http://localhost:5173/";
const browser = await chromium.launch({
  executablePath: process.env["FROND_CHROMIUM"] ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-background-networking", "--enable-unsafe-swiftshader"],
});
/** Samples of the coarse 64 x 64 among the 253 x 253. */
const COARSE = 64 ** 2 / 253 ** 2;

/** Milliseconds from a change of the document to the coarse and to the whole locus: the best of some changes. */
async function measure(workers) {
  const page = await browser.newPage();
  // Whoever is new here is greeted.
  await page.addInitScript(() => localStorage.setItem("frond.guide", "seen"));
  // Without a graphics card nothing but the locus costs anything worth speaking of.
  await page.goto(`${address}?workers=${workers}&backend=canvas#a=dragon-3&b=gasket&path=straight&t=0.5`);
  await page.waitForFunction(() => window.frond !== undefined);
  await page.evaluate(() => window.frond.idle());
  const best = { coarse: Number.POSITIVE_INFINITY, whole: Number.POSITIVE_INFINITY };
  for (let round = 0; round < 6; round++) {
    const a = round % 2 === 0 ? "dragon" : "dragon-3";
    const took = await page.evaluate(
      ([link, share]) =>
        new Promise((resolve) => {
          const start = performance.now();
          const took = {};
          // The former locus, complete, is still there at first.
          let fresh = false;
          const look = () => {
            const progress = window.frond.locusProgress();
            fresh ||= progress < 1;
            if (fresh && progress >= share) took.coarse ??= performance.now() - start;
            if (fresh && progress === 1) resolve({ ...took, whole: performance.now() - start });
            else requestAnimationFrame(look);
          };
          location.hash = link;
          requestAnimationFrame(look);
        }),
      [`a=${a}&b=gasket&path=straight&t=0.5`, COARSE],
    );
    await page.evaluate(() => window.frond.idle());
    best.coarse = Math.min(best.coarse, took.coarse);
    best.whole = Math.min(best.whole, took.whole);
  }
  await page.close();
  return best;
}

const [one, two] = [await measure(1), await measure(2)];
for (const [name, { coarse, whole }] of Object.entries({ "one worker": one, "two workers": two })) {
  console.log(
    `locus, ${name}: 64 x 64 after ${coarse.toFixed(0)} ms, 253 x 253 after ${whole.toFixed(0)} ms`,
  );
}
console.log(`two workers are ${(one.whole / two.whole).toFixed(2)} times one`);
await browser.close();
