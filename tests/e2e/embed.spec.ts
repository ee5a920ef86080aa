/** Frond in a frame of another page: what is seen of it, and what both say to each other. */
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { expectClean } from "./axe";
import { expect, test } from "./fixture";

interface Heard {
  frond: number;
  type: string;
  t?: number;
  playing?: boolean;
  fragment?: string;
  verdict?: string;
  message?: string;
}
type Host = Window & { heard: Heard[]; say(message: unknown): void };

test("a page of another origin shows a morph, and drives it", async ({ page, baseURL }) => {
  // Another port is another origin.
  const server = createServer((_, response) => {
    response.setHeader("content-type", "text/html").end(`<!doctype html><title>A plain page</title>
      <link rel="icon" href="data:," />
      <iframe src="${baseURL}embed.html?verdict#a=fern&b=tree&path=straight" title="A morph" width="600" height="360"></iframe>
      <script>
        const heard = [];
        addEventListener("message", ({ data }) => heard.push(data));
        const say = (message) => document.querySelector("iframe").contentWindow.postMessage(message, "*");
        Object.assign(window, { heard, say });
      </script>`);
  });
  await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
  await page.goto(`http://127.0.0.1:${(server.address() as AddressInfo).port}/`);
  const frame = page.frameLocator("iframe");
  const time = frame.getByRole("slider", { name: "Time" });
  await time.waitFor();
  await expect(frame.getByText(/piece|gap seen/)).toBeVisible();
  await expect(frame.getByRole("button")).toHaveCount(2);
  const say = (message: unknown) => page.evaluate((m) => (window as unknown as Host).say(m), message);
  const heard = () => page.evaluate(() => (window as unknown as Host).heard);
  // Nothing but that it listens is told before somebody asks.
  expect(await heard()).toEqual([{ frond: 1, type: "ready" }]);
  await say({ frond: 1, type: "hello" });
  await expect.poll(async () => (await heard()).at(1)?.type).toBe("state");
  await say({ frond: 1, type: "seek", t: 0.25 });
  await expect(time).toHaveAttribute("aria-valuetext", "25%");
  await expect.poll(async () => (await heard()).filter(({ t }) => t === 0.25).length).toBeGreaterThan(0);
  await say({ frond: 1, type: "play" });
  await expect(frame.getByRole("button", { name: "Pause" })).toBeVisible();
  await say({ frond: 1, type: "pause" });
  await expect(frame.getByRole("button", { name: "Play" })).toBeVisible();
  await say({ frond: 1, type: "open", fragment: "a=koch&b=gasket&t=1" });
  await expect
    .poll(async () => (await heard()).some(({ fragment }) => fragment?.includes("a=koch")))
    .toBe(true);
  await say({ frond: 1, type: "seek" });
  await expect.poll(async () => (await heard()).filter(({ type }) => type === "error").length).toBe(1);
  // A link that cannot be read is said to be one, and what is there stays.
  await say({ frond: 1, type: "open", fragment: "a=hammer" });
  await expect.poll(async () => (await heard()).filter(({ type }) => type === "error").length).toBe(2);
  expect((await heard()).findLast(({ type }) => type === "error")?.message).toContain("hammer");
  await expect.poll(async () => (await heard()).some(({ verdict }) => verdict !== undefined)).toBe(true);
  const out = frame.getByRole("link", { name: "Open in Frond" });
  await expect(out).toHaveAttribute("href", /^\.\/#v=1&check=[^&]+&a=koch&b=gasket/);
  server.close();
  server.closeAllConnections();
});

test("the picture fills the frame, however large and whatever its form", async ({ page, baseURL }) => {
  for (const [width, height] of [
    [640, 360],
    [900, 600],
    [1280, 720],
    [1920, 1080],
    [420, 900],
  ] as const) {
    await page.setViewportSize({ width, height });
    await page.goto(`${baseURL}embed.html#a=gasket&b=gasket&path=straight`);
    const picture = page.locator("canvas").first();
    await picture.waitFor();
    const foot = page.locator("footer");
    // Above it is nothing, and below it the slider.
    await expect
      .poll(async () => {
        const [box, below] = [await picture.boundingBox(), await foot.boundingBox()];
        return box && below && [box.x, box.y, box.width, Math.round(below.y - box.height)];
      })
      .toEqual([0, 0, width, 0]);
  }
});

test("by itself it is a page that everybody can use, with the map where that is asked for", async ({
  page,
}) => {
  await page.goto("./embed.html?locus&theme=dark&origin=https://nobody.example#a=koch&b=gasket&t=0.5");
  await page.getByRole("slider", { name: "Time" }).waitFor();
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
  await expect(page.getByRole("heading", { name: "Where the morph stays in one piece" })).toBeVisible();
  await page.waitForFunction(() => window.frond !== undefined);
  await page.evaluate(() => window.frond?.idle());
  await expectClean(page);
  // What the page around chose is not what the studio shows from now on.
  expect(await page.evaluate(() => localStorage.getItem("frond.theme"))).toBeNull();
});
