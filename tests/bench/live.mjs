// A drag in the page, in Chromium: the top map of A is pulled to and fro by the mouse for some seconds. How often the
// map of parameters is painted anew meanwhile, how long the page's frames take, and how soon after the hand has come
// to rest the whole map is there. Where FROND_ARGS let the browser have a graphics card that is faster, the map is the
// card's, and how many commands it was given is told.
import { chromium } from "@playwright/test";

const address = process.env["FROND_URL"] ?? "http://localhost:5173/";
const browser = await chromium.launch({
  executablePath: process.env["FROND_CHROMIUM"] ?? "/usr/bin/chromium",
  args: [
    "--no-sandbox",
    "--disable-background-networking",
    ...(process.env["FROND_ARGS"] ?? "--enable-unsafe-swiftshader").split(" "),
  ],
});
const SECONDS = 4;
/** A card is compared with the workers when the page has been at rest. */
const TRIAL_MS = process.env["FROND_ARGS"] ? 3000 : 0;

/** Notes when the map is painted, and every frame. */
function watch() {
  window.seen = { paints: [], frames: [], commands: 0 };
  const card = globalThis.GPUComputePassEncoder?.prototype;
  const { dispatchWorkgroups } = card ?? {};
  if (card)
    card.dispatchWorkgroups = function (...args) {
      window.seen.commands++;
      return dispatchWorkgroups.apply(this, args);
    };
  const { putImageData } = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.putImageData = function (...args) {
    if (this.canvas.closest?.(".locus-square")) window.seen.paints.push(performance.now());
    return putImageData.apply(this, args);
  };
  const frame = (at) => {
    window.seen.frames.push(at);
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}

async function measure(workers) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  // Whoever is new here is greeted.
  await page.addInitScript(() => localStorage.setItem("frond.guide", "seen"));
  await page.addInitScript(watch);
  await page.goto(`${address}?workers=${workers}#a=gasket&b=dragon-3&path=straight&t=0.5`);
  await page.waitForFunction(() => window.frond !== undefined);
  await page.evaluate(() => window.frond.idle());
  await page.waitForTimeout(TRIAL_MS);
  await page.getByRole("button", { name: "Edit the maps of A" }).click();
  await page.evaluate(() => window.frond.idle());
  const grip = page.getByRole("button", { name: /^Map 1, turns and scales it/ });
  const box = await grip.boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 4, y);
  const start = await page.evaluate(() => {
    window.seen.paints.length = 0;
    window.seen.frames.length = 0;
    window.seen.commands = 0;
    return performance.now();
  });
  for (let k = 1; ; k++) {
    const at = performance.timeOrigin + performance.now();
    const angle = k / 12;
    await page.mouse.move(x - 30 + 26 * Math.cos(angle), y + 26 * Math.sin(angle));
    const now = await page.evaluate(() => performance.now());
    if (now - start > 1000 * SECONDS) break;
    // As a mouse reports: not more often than a screen shows.
    const rest = 16 - (performance.timeOrigin + performance.now() - at);
    if (rest > 0) await page.waitForTimeout(rest);
  }
  const during = await page.evaluate(() => ({
    paints: window.seen.paints.slice(),
    frames: window.seen.frames.slice(),
    commands: window.seen.commands,
  }));
  const whole = await page.evaluate(
    () =>
      new Promise((resolve) => {
        const rested = performance.now();
        const look = () =>
          window.frond.locusProgress() === 1 ? resolve(performance.now() - rested) : setTimeout(look, 4);
        look();
      }),
  );
  await page.mouse.up();
  await page.close();
  const gaps = (times) => times.slice(1).map((time, k) => time - times[k]);
  const most = (times) => Math.max(0, ...gaps(times));
  return {
    paints: during.paints.length / SECONDS,
    wait: most(during.paints),
    frames: during.frames.length / SECONDS,
    longest: most(during.frames),
    commands: during.commands / SECONDS,
    whole,
  };
}

for (const workers of [1, 2]) {
  const rounds = [];
  for (let k = 0; k < 3; k++) rounds.push(await measure(workers));
  const best = (of) => rounds.map(of).sort((p, q) => p - q)[1];
  console.log(
    `${workers} worker(s): while dragged ${best((r) => r.paints).toFixed(1)} maps a second, ${best((r) => r.wait).toFixed(0)} ms ` +
      `at most from one to the next; ${best((r) => r.frames).toFixed(0)} frames a second, the longest ` +
      `${best((r) => r.longest).toFixed(0)} ms; ${best((r) => r.commands).toFixed(0)} commands of the card a second; the whole map ${best((r) => r.whole).toFixed(0)} ms after rest`,
  );
}
await browser.close();
