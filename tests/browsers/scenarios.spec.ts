/**
 * What anyone does first, in every browser of the table: each scenario asks the page alone, so that it does not matter
 * how the browser is driven. No complaint may be on the console.
 */
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import type { Page } from "@playwright/test";
import { preview } from "vite";
import { guess } from "../e2e/figure-pages";
import { file, leafPicture } from "../e2e/fit-tool";
import { address, folder } from "../e2e/site";
import { expect, test } from "./fixture";

const HOLDS = /In one piece, proved|No gap seen/;

const words = (page: Page, id: string) => page.getByTestId(id).textContent();

test("the first picture is drawn", async ({ studio, page }) => {
  await studio.open("a=fern&b=tree");
  const { lit, width, height, colours } = await studio.look();
  expect(lit).toBeGreaterThan(0.02 * width * height);
  expect(colours.length).toBeGreaterThan(3);
  // It is what the adaptive cut says, whatever draws here.
  expect(await studio.likeness()).toBeGreaterThanOrEqual(0.995);
  expect(await page.evaluate(() => window.frond?.backend())).toMatch(/^(webgpu|webgl2|canvas)$/);
});

test("it plays, and rests where it is paused", async ({ studio, page }) => {
  await studio.open("a=koch&b=gasket&path=straight");
  const before = await studio.look();
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await expect.poll(async () => (await studio.scene()).t).toBeGreaterThan(0.05);
  await page.getByRole("button", { name: "Pause", exact: true }).click();
  const after = await studio.look();
  expect(after.hash).not.toBe(before.hash);
  const { t } = await studio.scene();
  expect(await studio.look()).toEqual(after);
  expect((await studio.scene()).t).toBe(t);
});

test("a map is dragged by its corner, in one step of undo", async ({ studio, page }) => {
  await studio.open("a=gasket&b=gasket&path=straight");
  await page.getByRole("button", { name: "Edit the maps of A" }).click();
  const { maps } = (await studio.scene()).a;
  const box = await page.getByRole("button", { name: /^Map 1, turns and scales it/ }).boundingBox();
  if (!box) throw new Error("no grip");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 30, y + 10);
  await page.mouse.move(x - 60, y + 10);
  await page.mouse.up();
  const { a } = await studio.scene();
  expect(a.maps[0]).not.toEqual(maps[0]);
  expect(a.maps.slice(1)).toEqual(maps.slice(1));
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  expect((await studio.scene()).a.maps).toEqual(maps);
});

test("the locus is drawn, and a waypoint goes by keys", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&path=drawn:0.6,0.5");
  await expect.poll(() => page.evaluate(() => window.frond?.locusProgress())).toBe(1);
  const colours = await page.locator("canvas.locus-field").evaluate((canvas) => {
    const { width, height } = canvas as HTMLCanvasElement;
    const image = (canvas as HTMLCanvasElement).getContext("2d")?.getImageData(0, 0, width, height);
    return new Set(new Uint32Array(image?.data.buffer ?? new ArrayBuffer(0))).size;
  });
  expect(colours).toBeGreaterThan(3);
  await studio.way(1).focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowUp");
  const [point] = (await studio.scene()).path.points;
  expect(point?.[0]).toBeGreaterThan(0.6);
  expect(point?.[1]).toBeGreaterThan(0.5);
});

test("the verdict follows, and a proof is checked", async ({ studio, page }) => {
  await studio.open("a=terdragon&b=gasket&path=straight&t=0.995");
  await expect.poll(() => words(page, "verdict")).toMatch(/^In pieces.*by Frond’s own bounds$/);
  await studio.verdict.click();
  await page.getByRole("button", { name: "Check the proof" }).click();
  await page.getByText(/^Verified in exact arithmetic: [\d,]+ pairs? of pieces/).waitFor();
  await expect.poll(() => words(page, "verdict")).toMatch(/^In pieces, proved/);
  await studio.time.press("Home");
  await expect.poll(() => words(page, "verdict")).toMatch(HOLDS);
});

test("all four tools open, and draw", async ({ studio, page }) => {
  await studio.open("a=koch&b=gasket&path=straight&space=o:tetrahedron");
  const tool = (name: string) => page.getByRole("link", { name, exact: true }).click();
  const opened = async () => (await studio.scene()).tool ?? "morph";
  await tool("Deform");
  await expect.poll(opened).toBe("deform");
  await page.getByRole("button", { name: "Show me" }).click();
  expect((await studio.look()).lit).toBeGreaterThan(1000);
  expect((await studio.scene()).deform).toBeDefined();
  await tool("Space");
  await expect.poll(opened).toBe("space");
  await expect.poll(async () => (await studio.look()).lit, { timeout: 90_000 }).toBeGreaterThan(1000);
  await tool("Fit");
  await expect.poll(opened).toBe("fit");
  await expect.poll(() => words(page, "source"), { timeout: 90_000 }).toContain("Maple leaf");
  await tool("Morph");
  await expect.poll(opened).toBe("morph");
  expect((await studio.look()).lit).toBeGreaterThan(1000);
});

test("a leaf is taken from a photograph", async ({ studio, page }) => {
  const few = 12;
  await page.goto(`${address}#v=1&a=gasket&b=gasket&path=straight&tool=fit&fit=outline:closed,${few},0`);
  await expect.poll(() => words(page, "fit-status")).toMatch(/^\d.* error, \d+ numbers$/);
  await page.getByLabel("Photo or outline file").setInputFiles(file(leafPicture, "leaf.png"));
  await expect.poll(() => words(page, "source")).toContain("leaf.png");
  await expect.poll(() => words(page, "fit-status")).toBe("Cut out: one part");
  await page.getByRole("button", { name: "Fit this outline" }).click();
  await expect.poll(() => words(page, "fit-status")).toMatch(/^\d.* error, \d+ numbers$/);
  const curve = (await studio.scene()).fit?.curve?.curve;
  expect(curve?.knots.length).toBeGreaterThan(2);
  expect(curve?.knots.length).toBeLessThanOrEqual(few / 2);
});

test("a film is made, or the page says what this browser cannot make", async ({ studio, page }) => {
  await studio.open("a=fern&b=tree");
  // However the browser keeps files, this is what it is given.
  await page.evaluate(() => {
    const kept: Blob[] = [];
    Object.assign(window, { kept });
    const make = URL.createObjectURL;
    URL.createObjectURL = (blob: Blob) => {
      kept.push(blob);
      return make(blob);
    };
  });
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.getByRole("menuitem", { name: "Film …" }).click();
  const dialog = page.getByRole("dialog", { name: "Export" });
  const encodes = await page.evaluate(() => typeof VideoEncoder !== "undefined");
  if (!encodes) await dialog.getByText(/This browser/).waitFor();
  await dialog.getByRole("radio", { name: "GIF", exact: true }).press("Space");
  for (const [name, value] of [
    ["Width", "96"],
    ["Height", "64"],
    ["Frames per second", "10"],
    ["Length", "1"],
  ] as const) {
    const field = dialog.getByRole("spinbutton", { name, exact: true });
    await field.fill(value);
    await field.press("Enter");
  }
  await dialog.getByRole("button", { name: "Render the film" }).click();
  await dialog.getByRole("button", { name: "Make another" }).waitFor();
  const film = await page.evaluate(async () => {
    const { kept } = window as Window & { kept?: Blob[] };
    const blob = kept?.find(({ type }) => type === "image/gif");
    if (!blob) return null;
    const bytes = new Uint8Array(await blob.arrayBuffer());
    // Each frame has one graphic control extension of four bytes.
    let frames = 0;
    for (let i = 0; i < bytes.length; i++)
      if (bytes[i] === 0x21 && bytes[i + 1] === 0xf9 && bytes[i + 2] === 4 && bytes[i + 7] === 0) frames++;
    const image = await createImageBitmap(blob);
    const canvas = document.createElement("canvas");
    canvas.width = image.width;
    canvas.height = image.height;
    const context = canvas.getContext("2d");
    context?.drawImage(image, 0, 0);
    const data = context?.getImageData(0, 0, canvas.width, canvas.height).data ?? [];
    let green = 0;
    for (let i = 0; i < data.length; i += 4) if ((data[i + 1] ?? 0) > (data[i] ?? 0) + 20) green++;
    return { width: image.width, height: image.height, frames, green };
  });
  expect(film).toMatchObject({ width: 96, height: 64, frames: 20 });
  expect(film?.green).toBeGreaterThan(60);
});

test("a link opens the same, and back leads to the document before", async ({ studio, page }) => {
  await studio.open("a=levy&b=twindragon&path=straight&t=0.4&colour=address");
  await studio.time.press("ArrowRight");
  const mine = [await studio.scene(), await studio.look()];
  const link = await page.evaluate(() => location.href);
  await studio.open("a=koch&b=gasket");
  await page.evaluate((hash) => {
    location.hash = hash;
  }, new URL(link).hash);
  await expect.poll(async () => (await studio.scene()).a.preset).toBe("levy");
  expect([await studio.scene(), await studio.look()]).toEqual(mine);
  await page.evaluate(() => history.back());
  await expect.poll(async () => (await studio.scene()).a.preset).toBe("koch");
});

test("a lesson takes a guess, and shows the answer", async ({ page }) => {
  await page.goto(`${address}#learn/e6`);
  await page.getByRole("heading", { name: "What do you think?" }).waitFor();
  await guess(page);
  await page.getByRole("button", { name: "Show me" }).click();
  await page.getByTestId("badge").first().waitFor();
  const lit = () =>
    page.evaluate(() =>
      [...document.querySelectorAll<HTMLCanvasElement>("main canvas")].reduce((most, canvas) => {
        const image = canvas.getContext("2d")?.getImageData(0, 0, canvas.width || 1, canvas.height || 1);
        return Math.max(most, image?.data.filter((value, i) => i % 4 === 3 && value > 0).length ?? 0);
      }, 0),
    );
  await expect.poll(lit).toBeGreaterThan(500);
});

interface Heard {
  type: string;
  t?: number;
  verdict?: string;
}
type Host = Window & { heard: Heard[]; say(message: unknown): void };

test("a page of another origin shows a morph, and drives it", async ({ page }) => {
  const host = createServer((_, response) => {
    response.setHeader("content-type", "text/html").end(`<!doctype html><title>A plain page</title>
      <link rel="icon" href="data:," />
      <iframe src="${address}embed.html?verdict#a=fern&b=tree&path=straight" title="A morph"></iframe>
      <script>
        const heard = [];
        addEventListener("message", ({ data }) => heard.push(data));
        const say = (message) => document.querySelector("iframe").contentWindow.postMessage(message, "*");
        Object.assign(window, { heard, say });
      </script>`);
  });
  // Another port is another origin.
  await new Promise<void>((resolve) => host.listen(0, "127.0.0.1", resolve));
  await page.goto(`http://127.0.0.1:${(host.address() as AddressInfo).port}/`);
  const say = (message: unknown) => page.evaluate((m) => (window as unknown as Host).say(m), message);
  const heard = () => page.evaluate(() => (window as unknown as Host).heard);
  await expect.poll(async () => (await heard()).map(({ type }) => type)).toEqual(["ready"]);
  await say({ frond: 1, type: "hello" });
  await say({ frond: 1, type: "seek", t: 0.25 });
  await expect.poll(async () => (await heard()).some(({ t }) => t === 0.25)).toBe(true);
  await expect.poll(async () => (await heard()).some(({ verdict }) => verdict !== undefined)).toBe(true);
  host.close();
  host.closeAllConnections();
});

test("after a visit the studio works without its host", async ({ page }) => {
  const host = await preview({ base: folder, preview: { host: "127.0.0.1" }, logLevel: "silent" });
  const { port } = host.httpServer.address() as AddressInfo;
  const time = page.getByRole("slider", { name: "Time", exact: true });
  await page.goto(`http://127.0.0.1:${port}${folder}#a=koch&b=gasket&t=0.5`);
  await time.waitFor();
  await page.evaluate(() => window.frond?.drawn());
  const missing = () =>
    page.evaluate(async () => {
      const kept = (await (await caches.open("frond")).keys()).map(({ url }) => url);
      const loaded = [location.href, ...performance.getEntriesByType("resource").map(({ name }) => name)];
      return loaded
        .map((url) => url.replace(/[?#].*/, ""))
        .filter((url) => url.startsWith("http") && !kept.includes(url));
    });
  await expect.poll(missing).toEqual([]);
  await host.close();
  await page.reload();
  await time.waitFor();
  await page.evaluate(() => window.frond?.drawn());
  const lit = await page.evaluate(async () => {
    const { data = [] } = (await window.frond?.readPixels()) ?? {};
    let lit = 0;
    for (let i = 3; i < data.length; i += 4) if (data[i]) lit++;
    return lit;
  });
  expect(lit).toBeGreaterThan(1000);
  await expect.poll(() => words(page, "verdict")).toMatch(/piece|gap seen/);
});
