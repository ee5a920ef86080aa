// Space in the page: what is done while nothing moves, how a view and an object move, and what a conjugation costs
// beside a frame. FROND_URL is the built site, FROND_CHROMIUM the browser.
import { chromium } from "@playwright/test";

const browser = await chromium.launch({
  executablePath: process.env["FROND_CHROMIUM"] ?? "/usr/bin/chromium",
  args: [
    "--no-sandbox",
    "--disable-quic",
    "--no-first-run",
    "--enable-unsafe-swiftshader",
    "--use-angle=swiftshader",
  ],
});
const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
// Whoever is new here is greeted.
await page.addInitScript(() => localStorage.setItem("frond.guide", "seen"));
await page.addInitScript(() => {
  const counts = { frames: 0, clouds: 0 };
  Object.assign(window, { counts });
  const ask = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (run) => {
    counts.frames++;
    return ask(run);
  };
});

async function open(space) {
  await page.goto("about:blank");
  await page.goto(`${process.env["FROND_URL"] ?? "http://localhost:5173/"}#tool=space&space=${space}`);
  await page.getByTestId("space-status").getByText("Complete picture").waitFor({ timeout: 120_000 });
}

/** Frames that are asked for while something goes on. */
async function frames(act) {
  const before = await page.evaluate(() => window.counts.frames);
  const start = performance.now();
  await act();
  const seconds = (performance.now() - start) / 1000;
  return { count: (await page.evaluate(() => window.counts.frames)) - before, seconds };
}

/** The pointer goes round in the middle of the stage for so many steps. */
async function drag(steps) {
  const box = await page.getByTestId("space-stage").boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 0; i < steps; i++) {
    await page.mouse.move(x + 90 * Math.sin(i / 8), y + 40 * Math.sin(i / 5));
    await page.evaluate(() => new Promise((done) => setTimeout(done)));
  }
  await page.mouse.up();
}

for (const [name, space] of [
  ["sponge", "o:sponge"],
  ["fern", "o:fern"],
]) {
  const start = performance.now();
  await open(space);
  console.log(
    `${name}: complete after ${((performance.now() - start) / 1000).toFixed(1)} s, with all that loads`,
  );
  // What is still smoothed, and the thumbnails of the gallery, come to their end.
  await page.waitForTimeout(6000);
  const still = await frames(() => page.waitForTimeout(3000));
  console.log(`${name}: ${still.count} frames in ${still.seconds.toFixed(1)} s at rest`);
  const round = await frames(() => drag(60));
  console.log(`${name}: ${(round.count / round.seconds).toFixed(1)} frames a second while the view turns`);
  await page.getByRole("radio", { name: "Rotate", exact: true }).first().check({ force: true });
  const turned = await frames(() => drag(60));
  console.log(
    `${name}: ${(turned.count / turned.seconds).toFixed(1)} frames a second while its parameters turn`,
  );
}
await browser.close();
