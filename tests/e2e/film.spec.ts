/** Films of the plane: the dialog, and what comes out of it. Their files' forms are tested beside the code. */
import { readFile } from "node:fs/promises";
import type { Page } from "@playwright/test";
import { expectClean } from "./axe";
import { expect, test } from "./fixture";

/** Chooses a kind and numbers, and makes the film. */
async function film(page: Page, kind: string, numbers: Record<string, string>): Promise<Buffer> {
  const dialog = page.getByRole("dialog", { name: "Export" });
  await dialog.getByRole("radio", { name: kind, exact: true }).check({ force: true });
  for (const [name, value] of Object.entries(numbers)) {
    const field = dialog.getByRole("spinbutton", { name, exact: true });
    await field.fill(value);
    await field.press("Enter");
  }
  const download = page.waitForEvent("download", { timeout: 120_000 });
  await dialog.getByRole("button", { name: "Render the film" }).click();
  return readFile(await (await download).path());
}

/**
 * The frames of a moving picture as the browser sees them: how long each stands, what is lit of it, and in its upper
 * right corner, in a square of 0.3 of its height: the part that is not the ground, and its pixels as a number.
 */
async function framesOf(page: Page, bytes: Buffer, type: string) {
  return page.evaluate(
    async ({ base64, type }) => {
      const data = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const decoder = new ImageDecoder({ data, type });
      await decoder.tracks.ready;
      const frames: {
        milliseconds: number;
        hash: number;
        clear: number;
        lit: number;
        corner: number;
        cornerHash: number;
      }[] = [];
      for (let frameIndex = 0; frameIndex < (decoder.tracks.selectedTrack?.frameCount ?? 0); frameIndex++) {
        const { image } = await decoder.decode({ frameIndex });
        const canvas = new OffscreenCanvas(image.displayWidth, image.displayHeight);
        const context = canvas.getContext("2d", { willReadFrequently: true });
        context?.drawImage(image, 0, 0);
        const pixels =
          context?.getImageData(0, 0, canvas.width, canvas.height).data ?? new Uint8ClampedArray();
        let [hash, clear, lit] = [0, 0, 0];
        for (let i = 0; i < pixels.length; i += 4) {
          hash = (Math.imul(hash, 31) + (pixels[i] ?? 0) + 256 * (pixels[i + 1] ?? 0)) | 0;
          if (pixels[i + 3] === 0) clear++;
          else if ([0, 1, 2].some((k) => pixels[i + k] !== pixels[k])) lit++;
        }
        const side = Math.round(0.3 * canvas.height);
        const square =
          context?.getImageData(canvas.width - side, 0, side, side).data ?? new Uint8ClampedArray();
        let [corner, cornerHash] = [0, 0];
        for (let i = 0; i < square.length; i += 4) {
          if ([0, 1, 2].some((k) => square[i + k] !== pixels[k])) corner += 4 / square.length;
          cornerHash = (Math.imul(cornerHash, 31) + (square[i] ?? 0)) | 0;
        }
        const milliseconds = (image.duration ?? 0) / 1000;
        frames.push({ milliseconds, hash, clear, lit, corner, cornerHash });
        image.close();
      }
      return frames;
    },
    { base64: bytes.toString("base64"), type },
  );
}

test("a morph becomes a film that goes to and fro, and a clear one, frame by frame", async ({
  studio,
  page,
}) => {
  await studio.open("a=fern&b=tree");
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.getByRole("menuitem", { name: "Film …" }).click();
  const dialog = page.getByRole("dialog", { name: "Export" });
  await dialog.getByRole("img", { name: "First frame" }).waitFor();
  await expectClean(page);

  const small = { Width: "96", Height: "64", "Frames per second": "10", Length: "1" };
  const gif = await framesOf(page, await film(page, "GIF", small), "image/gif");
  expect(gif.map(({ milliseconds }) => milliseconds)).toEqual(Array.from({ length: 20 }, () => 100));
  expect(Math.min(...gif.map(({ lit }) => lit))).toBeGreaterThan(60);
  // The way back is the way there, and the last frame goes on to the first.
  for (let i = 1; i < 10; i++) expect(gif[20 - i]?.hash).toBe(gif[i]?.hash);
  expect(new Set(gif.slice(0, 11).map(({ hash }) => hash)).size).toBe(11);
  await expect(dialog.getByText("20 frames")).toBeVisible();

  // The map is in the corner, which is free without it, and the mark moves on it.
  await dialog.getByRole("button", { name: "Make another" }).click();
  const inset = dialog.getByRole("switch", { name: "Inset: position on the locus" });
  await inset.check();
  const mapped = await framesOf(page, await film(page, "APNG", small), "image/png");
  expect(Math.max(...gif.map(({ corner }) => corner))).toBe(0);
  expect(Math.min(...mapped.map(({ corner }) => corner))).toBeGreaterThan(0.8);
  expect(new Set(mapped.slice(0, 11).map(({ cornerHash }) => cornerHash)).size).toBeGreaterThan(5);
  await dialog.getByRole("button", { name: "Make another" }).click();
  await inset.uncheck();
  await dialog.getByRole("radio", { name: "None" }).check({ force: true });
  await dialog.getByRole("combobox", { name: "Background" }).selectOption("clear");
  const apng = await framesOf(page, await film(page, "APNG", { "Pause at both ends": "0.2" }), "image/png");
  // Either end stands still for two frames more.
  expect(apng.map(({ milliseconds }) => milliseconds)).toEqual([
    300,
    ...Array.from({ length: 8 }, () => 100),
    300,
  ]);
  expect(Math.min(...apng.map(({ clear }) => clear))).toBeGreaterThan(1000);

  // A shape in the making: each step stands for a second, and is one frame.
  await dialog.getByRole("button", { name: "Make another" }).click();
  await dialog.getByRole("radio", { name: "Step by step" }).check({ force: true });
  const steps = await framesOf(page, await film(page, "APNG", {}), "image/png");
  expect(steps.length).toBeGreaterThan(5);
  expect(steps.every(({ milliseconds }) => milliseconds === 1000)).toBe(true);

  // What is not wanted any more ends, and the dialog is as it was.
  await dialog.getByRole("button", { name: "Make another" }).click();
  await dialog.getByRole("radio", { name: "The morph" }).check({ force: true });
  await dialog.getByRole("combobox", { name: "Size" }).selectOption("full");
  // By keys alone: the focus goes from one button to that which takes its place.
  const begin = dialog.getByRole("button", { name: "Render the film" });
  await begin.press("Enter");
  const end = dialog.getByRole("button", { name: "Cancel" });
  await expect(end).toBeFocused();
  await end.press("Enter");
  await expect(begin).toBeFocused();

  // It goes on while the dialog is closed, in another tool and among the figures; there it is ended, too.
  await dialog.getByRole("button", { name: "Render the film" }).click();
  await page.keyboard.press("Escape");
  await expect(dialog).toHaveCount(0);
  const chip = page.getByRole("region", { name: "The film in progress" });
  await expect(chip.getByRole("progressbar", { name: "Frames rendered" })).toBeVisible();
  await expectClean(page);
  // The chip is away while its dialog is open, and has the focus when it is back.
  const watch = chip.getByRole("button", { name: /^Film \d+%$/ });
  await watch.press("Enter");
  await expect(chip).toHaveCount(0);
  await page.keyboard.press("Escape");
  await expect(watch).toBeFocused();
  await page.getByRole("link", { name: "Figures" }).click();
  await watch.click();
  await expect(dialog.getByRole("button", { name: "Cancel" })).toBeVisible();
  await page.keyboard.press("Escape");
  await chip.getByRole("button", { name: "Cancel the film" }).click();
  await expect(chip).toHaveCount(0);
  await page.goBack();

  // What was made meanwhile is shown when one likes.
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.getByRole("menuitem", { name: "Film …" }).click();
  for (const side of ["Width", "Height"]) {
    await dialog.getByRole("spinbutton", { name: side }).fill("64");
    await dialog.getByRole("spinbutton", { name: side }).press("Enter");
  }
  const download = page.waitForEvent("download", { timeout: 120_000 });
  await dialog.getByRole("button", { name: "Render the film" }).click();
  await page.keyboard.press("Escape");
  await download;
  const there = page.getByRole("region", { name: "The film", exact: true });
  await expect(there).toContainText("The film is in your downloads.");
  await there.getByRole("button", { name: "Open" }).click();
  await expect(dialog.getByText("160 frames")).toBeVisible();
  await expect(there).toHaveCount(0);
  await page.keyboard.press("Escape");
  await expect(there).toHaveCount(0);

  // One step as a picture, from the figure that is chosen.
  const picture = async (seed: string) => {
    await page.getByRole("button", { name: "Save", exact: true }).click();
    await page.getByRole("menuitem", { name: "Picture of any size …" }).click();
    const pictures = page.getByRole("dialog", { name: "Save the picture" });
    await pictures.getByRole("radio", { name: "Step by step" }).check({ force: true });
    await pictures.getByRole("combobox", { name: "Starts with" }).selectOption(seed);
    for (const [name, value] of [
      ["Steps", "2"],
      ["Width", "96"],
      ["Height", "64"],
    ] as const) {
      const field = pictures.getByRole("spinbutton", { name });
      await field.fill(value);
      await field.press("Enter");
    }
    const download = page.waitForEvent("download");
    await pictures.getByRole("button", { name: "Save as PNG" }).click();
    expect((await download).suggestedFilename()).toMatch(/-steps-2\.png$/);
    return framesOf(page, await readFile(await (await download).path()), "image/png");
  };
  const [square, point] = [await picture("square"), await picture("point")];
  expect(square[0]?.lit).toBeGreaterThan(3 * (point[0]?.lit ?? Number.POSITIVE_INFINITY));
  expect(point[0]?.lit).toBeGreaterThan(0);
});

test("flat colours of a GIF are exact, and a video says which colours it has", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&path=straight");
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.getByRole("menuitem", { name: "Film …" }).click();
  const dialog = page.getByRole("dialog", { name: "Export" });
  const again = () => dialog.getByRole("button", { name: "Make another" }).click();
  const small = { Width: "96", Height: "64", "Frames per second": "10", Length: "1" };
  const gif = await framesOf(page, await film(page, "GIF", small), "image/gif");
  await again();
  const apng = await framesOf(page, await film(page, "APNG", {}), "image/png");
  expect(gif.map(({ hash }) => hash)).toEqual(apng.map(({ hash }) => hash));

  // Read back by the browser: what a frame is made of, its tags, and the colour of its corner.
  const decoded = (bytes: Buffer) =>
    page.evaluate(async (base64) => {
      const data = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const video = document.createElement("video");
      video.src = URL.createObjectURL(new Blob([data], { type: "video/webm" }));
      video.muted = true;
      const there = new Promise((shown) => video.requestVideoFrameCallback(shown));
      await video.play();
      await there;
      video.pause();
      const frame = new VideoFrame(video);
      const { format, colorSpace } = frame;
      const { matrix, primaries, fullRange } = colorSpace.toJSON();
      const canvas = new OffscreenCanvas(frame.displayWidth, frame.displayHeight);
      const context = canvas.getContext("2d", { willReadFrequently: true });
      context?.drawImage(frame, 0, 0);
      frame.close();
      const corner = [...(context?.getImageData(0, 0, 1, 1).data ?? [])].slice(0, 3);
      return { format, matrix, primaries, fullRange, corner, seconds: video.duration };
    }, bytes.toString("base64"));
  const ground = [251, 250, 246];
  for (const [chroma, format] of [
    ["4:2:0", "I420"],
    ["4:4:4", "I444"],
  ] as const) {
    await again();
    await dialog.getByRole("radio", { name: "WebM" }).check({ force: true });
    await dialog.getByRole("radio", { name: chroma }).check({ force: true });
    const { corner, seconds, ...about } = await decoded(await film(page, "WebM", {}));
    expect(about).toEqual({ format, matrix: "bt709", primaries: "bt709", fullRange: false });
    expect(seconds).toBeCloseTo(2, 1);
    corner.forEach((channel, k) => {
      expect(Math.abs(channel - (ground[k] ?? 0))).toBeLessThanOrEqual(3);
    });
  }
});

test("a bend is filmed once round; where nothing moves the way to it is offered", async ({
  studio,
  page,
}) => {
  await studio.open("a=fern&b=fern&tool=deform");
  const open = async () => {
    await page.getByRole("button", { name: "Save", exact: true }).click();
    await page.getByRole("menuitem", { name: "Film …" }).click();
  };
  await open();
  const dialog = page.getByRole("dialog", { name: "Export" });
  await dialog.getByRole("button", { name: "Use the motion Sway" }).click();
  await page.getByRole("button", { name: "Pause", exact: true }).click();
  await open();
  const small = { Width: "96", Height: "64", "Frames per second": "10", To: "1" };
  const frames = await framesOf(page, await film(page, "GIF", small), "image/gif");
  expect(frames).toHaveLength(10);
  expect(new Set(frames.map(({ hash }) => hash)).size).toBeGreaterThan(7);
  expect(Math.min(...frames.map(({ lit }) => lit))).toBeGreaterThan(60);
  await page.keyboard.press("Escape");

  // The moment itself, in strips: more rows than are drawn at a time.
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.getByRole("menuitem", { name: "Picture of any size …" }).click();
  const pictures = page.getByRole("dialog", { name: "Save the picture" });
  for (const [name, value] of [
    ["Width", "8192"],
    ["Height", "600"],
  ] as const) {
    const field = pictures.getByRole("spinbutton", { name });
    await field.fill(value);
    await field.press("Enter");
  }
  await pictures.getByRole("combobox", { name: "Background" }).selectOption("night");
  await expectClean(page);
  const download = page.waitForEvent("download");
  await pictures.getByRole("button", { name: "Save as PNG" }).click();
  const png = await readFile(await (await download).path());
  expect([png.readUInt32BE(16), png.readUInt32BE(20)]).toEqual([8192, 600]);
  const [whole] = await framesOf(page, png, "image/png");
  expect(whole?.clear).toBe(0);
  expect(whole?.lit).toBeGreaterThan(1000);
  await expect(pictures).toHaveCount(0);
});
