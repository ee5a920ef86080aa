import { expect, test } from "./fixture";

test.use({ alone: true });

test("it asks for nothing but its own files, from a folder of a plain host", async ({ studio, page }) => {
  const asked: string[] = [];
  page.on("request", (request) => asked.push(request.url()));
  // Chromium says so each time that it is asked for WebGPU where it has none.
  let without = 0;
  page.on("console", (message) => {
    if (message.text().includes("No available adapters")) without++;
  });
  await studio.open("a=gasket&b=gasket");
  await studio.idle();
  await page.getByRole("link", { name: "Figures" }).click();
  await expect(studio.time).toHaveCount(0);
  await page.goBack();
  await studio.time.waitFor();
  const folder = new URL("./", page.url().split("#")[0]);
  expect(folder.pathname).toBe("/some/folder/");
  const strangers = asked.filter(
    (url) => !url.startsWith(folder.href) && !url.startsWith("data:") && !url.startsWith("blob:"),
  );
  expect(strangers).toEqual([]);
  // Each module is fetched once, and handed to the workers.
  const modules = asked.filter((url) => url.endsWith(".wasm"));
  expect(modules).toHaveLength(new Set(modules).size);
  // So is the graphics card.
  expect(without).toBeLessThanOrEqual(1);
});

test("once loaded it works without the network", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&path=straight");
  const before = await studio.look();
  await studio.idle();
  await page.context().setOffline(true);
  await page.getByRole("button", { name: /^Shape A: / }).click();
  await page.getByRole("dialog").getByRole("button", { name: /^Koch/ }).click();
  await studio.time.press("End");
  await page.evaluate(() => window.frond?.killWorker());
  expect((await studio.look()).hash).not.toBe(before.hash);
  await expect(studio.verdict).toHaveText(/piece|gap seen/);
  await expect(studio.alerts).toHaveCount(0);
});

test("a picture is saved", async ({ studio, page }) => {
  await studio.open("a=gasket&b=gasket");
  await studio.drawn();
  const saving = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.getByRole("menuitem", { name: "Save as PNG" }).click();
  const file = await saving;
  expect(file.suggestedFilename()).toBe("frond-gasket-gasket-0.00.png");
  const bytes = await read(await file.createReadStream());
  // It carries the address of what it shows.
  const address = await page.evaluate(() => location.href.split("#")[0]);
  const text = bytes.toString("latin1");
  const link = text.slice(text.indexOf("Frond link\0\0\0\0\0") + "Frond link\0\0\0\0\0".length);
  expect(link.startsWith(`${address}#v=1&check=`)).toBe(true);
  expect(link).toMatch(/^[^&]*&check=[0-9a-z-]+&a=gasket&b=gasket/);
  const size = await page.evaluate(
    async (bytes) => {
      const bitmap = await createImageBitmap(new Blob([new Uint8Array(bytes)], { type: "image/png" }));
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = canvas.getContext("2d");
      context?.drawImage(bitmap, 0, 0);
      const data = context?.getImageData(0, 0, bitmap.width, bitmap.height).data ?? [];
      let lit = 0;
      for (let i = 3; i < data.length; i += 4) if (data[i]) lit++;
      return { long: Math.max(bitmap.width, bitmap.height), share: lit / (bitmap.width * bitmap.height) };
    },
    [...bytes],
  );
  expect(size.long).toBe(2400);
  expect(size.share).toBeGreaterThan(0.005);
  expect(size.share).toBeLessThan(0.5);
});

async function read(stream: AsyncIterable<Uint8Array>): Promise<Buffer> {
  const parts: Uint8Array[] = [];
  for await (const part of stream) parts.push(part);
  return Buffer.concat(parts);
}
