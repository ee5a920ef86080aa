// The picture in the page, in Chromium, while the time of a morph is scrubbed by the mouse. What is asked goes through
// the page as a person's hand would, and through its hook, `window.frond`.
import { chromium } from "@playwright/test";

const SECONDS = 4;
const MORPH = "a=dragon&b=gasket&path=straight&t=0";
/** A frame is whole where it lights so much of what the complete picture of the same moment lights. */
const WHOLE = 0.97;
/** A sixth of a second: what is shown may be of a moment so long before the one that the hand asks for. */
const OLDEST = 10;
const SAMPLES = 16;
const SOFTWARE = {
  webgl2: ["--enable-unsafe-swiftshader", "--use-angle=swiftshader"],
  webgpu: [
    "--enable-unsafe-webgpu",
    "--use-webgpu-adapter=swiftshader",
    "--enable-features=Vulkan",
    "--use-vulkan=swiftshader",
    "--use-angle=swiftshader",
  ],
};
/** What the page chooses by itself depends on what there is: here a software card that both interfaces reach. */
const BACKENDS = {
  canvas: SOFTWARE.webgl2,
  webgl2: SOFTWARE.webgl2,
  webgpu: SOFTWARE.webgpu,
  auto: SOFTWARE.webgpu,
};

/**
 * In the page, before its own scripts: what is shown can be looked at. What WebGL has drawn is there later, and what
 * WebGPU has drawn is looked at within the same task, after each function that draws.
 */
function keepDrawn() {
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    return getContext.call(
      this,
      kind,
      kind === "webgl2" ? { ...options, preserveDrawingBuffer: true } : options,
    );
  };
  const ask = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (run) =>
    ask((at) => {
      run(at);
      window.watched?.drawn();
    });
}

/** In the page: notes every frame, and takes a copy of what the stage shows in some. */
function watch(every) {
  const seen = { frames: [], times: [], shots: [] };
  const stage = document.querySelector('section[aria-label="Picture"]');
  const { width: across } = stage.getBoundingClientRect();
  const capture = () => {
    const shown = [...stage.querySelectorAll("canvas")].filter((canvas) => {
      const style = getComputedStyle(canvas);
      const hidden = style.visibility === "hidden" || style.opacity === "0";
      return !hidden && canvas.getBoundingClientRect().width > across / 2;
    });
    const [{ width, height }] = shown;
    const copy = new OffscreenCanvas(width, height);
    const context = copy.getContext("2d");
    for (const canvas of shown) context.drawImage(canvas, 0, 0, width, height);
    return context.getImageData(0, 0, width, height).data;
  };
  const isLit = (pixels) => pixels.some((byte, i) => i % 4 === 3 && byte > 0);
  let running = true;
  let due = false;
  const frame = (at) => {
    if (!running) return;
    requestAnimationFrame(frame);
    seen.frames.push(at);
    seen.times.push(window.frond.scene().t);
    due ||= every > 0 && seen.frames.length % every === 0;
  };
  requestAnimationFrame(frame);
  window.watched = {
    drawn() {
      if (!due || !running) return;
      const pixels = capture();
      // What WebGPU has not drawn just now cannot be seen.
      if (window.frond.backend() === "webgpu" && !isLit(pixels)) return;
      due = false;
      seen.shots.push({ frame: seen.frames.length - 1, pixels });
    },
    stop() {
      running = false;
      return { frames: seen.frames, times: seen.times, shots: seen.shots.map(({ frame }) => frame) };
    },
    /** Of the pixels that are lit now, at rest, those that a shot lights, and of those that either lights, both. */
    async likeness(shot) {
      const then = seen.shots[shot].pixels;
      const { data: now } = await window.frond.readPixels();
      let [both, either, complete] = [0, 0, 0];
      for (let i = 3; i < now.length; i += 4) {
        const [a, b] = [then[i] > 0, now[i] > 0];
        both += a && b ? 1 : 0;
        either += a || b ? 1 : 0;
        complete += b ? 1 : 0;
      }
      return { covered: both / Math.max(1, complete), alike: both / Math.max(1, either) };
    },
  };
}

async function open(browser, address, backend, kept) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  // Whoever is new here is greeted.
  await page.addInitScript(() => localStorage.setItem("frond.guide", "seen"));
  if (kept) await page.addInitScript(keepDrawn);
  await page.goto(`${address}${backend === "auto" ? "" : `?backend=${backend}`}#${MORPH}`);
  await page.waitForFunction(() => window.frond !== undefined);
  await page.evaluate(() => window.frond.idle());
  return page;
}

/** Drags the time slider from one end to the other. */
async function drag(page) {
  const box = await page.getByRole("slider", { name: "Time", exact: true }).boundingBox();
  const y = box.y + box.height / 2;
  const [left, right] = [box.x + 8, box.x + box.width - 8];
  await page.mouse.move(left, y);
  await page.mouse.down();
  const start = performance.now();
  for (let now = start; now - start < 1000 * SECONDS; now = performance.now()) {
    await page.mouse.move(left + ((right - left) * (now - start)) / (1000 * SECONDS), y);
    // As a mouse reports: not more often than a screen shows.
    const rest = 16 - (performance.now() - now);
    if (rest > 0) await page.waitForTimeout(rest);
  }
  const seen = await page.evaluate(() => window.watched.stop());
  await page.mouse.up();
  return seen;
}

/** Brings the page to a moment, at rest. */
const rest = (page, t) =>
  page.evaluate(
    async ([link, t]) => {
      location.hash = link.replace("t=0", `t=${t}`);
      await new Promise((done) => setTimeout(done, 50));
      await window.frond.drawn();
    },
    [MORPH, t],
  );

/** Which of the frames that were looked at were whole, and how old they were. */
async function judge(page, { frames, times, shots }) {
  const judged = [];
  for (const [k, frame] of shots.entries()) {
    let best = { covered: 0, alike: 0, age: 0 };
    // What was asked for in one of the last frames.
    const moments = new Map();
    for (let back = 0; back <= Math.min(OLDEST, frame); back++) {
      const t = times[frame - back];
      if (!moments.has(t)) moments.set(t, frames[frame] - frames[frame - back]);
    }
    for (const [t, age] of moments) {
      await rest(page, t);
      const found = await page.evaluate((k) => window.watched.likeness(k), k);
      if (found.alike > best.alike) best = { ...found, age };
      if (best.alike > 0.99) break;
    }
    judged.push(best);
  }
  return judged;
}

const middle = (numbers) => [...numbers].sort((a, b) => a - b)[numbers.length >> 1] ?? Number.NaN;

export async function scrub(address) {
  console.log(`in the page: the time of dragon to gasket is scrubbed for ${SECONDS} s at 1280 x 800`);
  const executablePath = process.env["FROND_CHROMIUM"] ?? "/usr/bin/chromium";
  for (const [backend, flags] of Object.entries(BACKENDS)) {
    const args = ["--no-sandbox", "--disable-background-networking", ...flags];
    const browser = await chromium.launch({ executablePath, args });
    try {
      console.log(`  ${backend.padEnd(7)}${await measured(browser, address, backend)}`);
    } catch (problem) {
      // A software card may end its process where a machine is short of memory or time.
      console.log(`  ${backend.padEnd(7)}could not be measured: ${String(problem).split("\n")[0]}`);
    } finally {
      await browser.close();
    }
  }
}

/** Once to see how long frames take, and once more to see what they show: copies take time. */
async function measured(browser, address, backend) {
  let page = await open(browser, address, backend, false);
  const used = await page.evaluate(() => window.frond.backend());
  await page.evaluate(watch, 0);
  const { frames } = await drag(page);
  await page.close();
  const gaps = frames.slice(1).map((at, k) => at - frames[k]);
  page = await open(browser, address, backend, true);
  await page.evaluate(watch, Math.max(1, Math.floor(frames.length / SAMPLES)));
  const judged = await judge(page, await drag(page));
  const whole = judged.filter(({ covered }) => covered >= WHOLE).length;
  return (
    `${used}: ${(gaps.length / SECONDS).toFixed(0)} frames a second, the longest ${Math.max(...gaps).toFixed(0)} ms; ` +
    `${whole} of ${judged.length} that were looked at were whole, the one in the middle shows ` +
    `${(100 * middle(judged.map(({ covered }) => covered))).toFixed(1)}% of a moment ` +
    `${middle(judged.map(({ age }) => age)).toFixed(0)} ms before`
  );
}
