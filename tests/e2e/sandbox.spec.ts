/** Frond in a sandboxed frame, which has no origin: on a host that allows it to fetch, and on one that does not. */
import { readFile } from "node:fs/promises";
import { createServer, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, test } from "./fixture";

const dist = fileURLToPath(new URL("../../dist/", import.meta.url));
const TYPES: Readonly<Record<string, string>> = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".wasm": "application/wasm",
};

// The tab of the other tests has something to do with the storage of each page, and here there is none.
test.use({ alone: true });

const servers: Server[] = [];

async function served(
  answer: (path: string) => Promise<[type: string, body: string | Buffer]>,
  cors = false,
) {
  const server = createServer(async ({ url = "/" }, response) => {
    if (cors) response.setHeader("access-control-allow-origin", "*");
    try {
      const [type, body] = await answer(new URL(url, "http://here/").pathname);
      response.setHeader("content-type", type).end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  servers.push(server);
  await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
  return `http://127.0.0.1:${(server.address() as AddressInfo).port}/`;
}

/** A page with a sandboxed frame of the site. */
async function framed(address: string, cors: boolean): Promise<string> {
  const site = await served(async (path) => {
    const file = join(dist, normalize(path));
    return [TYPES[extname(file)] ?? "application/octet-stream", await readFile(file)];
  }, cors);
  return served(async () => [
    "text/html",
    `<!doctype html><title>A careful page</title><link rel="icon" href="data:," />
    <iframe sandbox="allow-scripts" src="${site}${address}" title="Frond" width="640" height="400"></iframe>`,
  ]);
}

test.afterEach(() => {
  for (const server of servers.splice(0)) {
    server.close();
    server.closeAllConnections();
  }
});

test("shows all it has where the host lets anybody fetch it", async ({ page }) => {
  await page.goto(await framed("embed.html?verdict#a=dragon-3&b=gasket&t=0.4", true));
  const frame = page.frameLocator("iframe");
  await frame.getByRole("slider", { name: "Time" }).waitFor();
  await expect(frame.getByText(/piece|gap seen/)).toBeVisible();
  // Workers decide it, and nothing went wrong.
  await expect(frame.getByText("no workers")).toHaveCount(0);
  await expect(frame.getByRole("alert")).toHaveCount(0);

  await page.goto(await framed("index.html#a=fern&b=tree", true));
  await expect(frame.getByRole("button", { name: "Share" })).toBeVisible();
  await expect(frame.getByRole("alert")).toHaveCount(0);
});

test.describe("where the host does not", () => {
  // The browser says of each file that it may not be had.
  test.use({
    expected: /CORS policy|ERR_FAILED|\.(?:js|css|wasm) failed|was preloaded|Content Security Policy/,
  });

  test("shows morphs, and says of the rest what to do", async ({ page }) => {
    await page.goto(await framed("embed.html#a=dragon-3&b=gasket&path=straight&t=0.4", false));
    const frame = page.frameLocator("iframe");
    await expect(frame.getByRole("img", { name: "Dragon of three on its way to Gasket, 40%" })).toBeVisible();
    await frame.getByRole("slider", { name: "Time" }).press("End");
    await expect(
      frame.getByRole("img", { name: "Dragon of three on its way to Gasket, 100%" }),
    ).toBeVisible();
    for (const [address, words] of [
      ["embed.html#learn/e1", "Only morphs are shown here"],
      ["index.html#a=fern&b=tree", "Frond cannot be loaded in this frame"],
    ] as const) {
      await page.goto(await framed(address, false));
      await expect(frame.getByRole("alert")).toContainText(words);
      await expect(frame.getByRole("alert")).toContainText("allow-same-origin");
    }
  });
});
