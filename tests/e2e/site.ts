/** Where the built site is served for tests in browsers. */
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../..", import.meta.url));
const port = Number(process.env["FROND_PORT"] ?? 4179);

/** The site is built with relative addresses; to prove it, it is tried in a folder below the host's root. */
export const folder = "/some/folder/";

/** FROND_URL is the address of a site that is served already. */
const served = process.env["FROND_URL"];

export const address = served ?? `http://127.0.0.1:${port}${folder}`;

/** What Playwright starts before the tests. */
export const siteServer = served === undefined ? { webServer: server() } : {};

function server() {
  return {
    command: `node node_modules/vite/bin/vite.js preview --base ${folder} --host 127.0.0.1 --port ${port} --strictPort`,
    cwd: root,
    url: address,
    reuseExistingServer: false,
  };
}
