/**
 * The hosts, in the order of `docs/embed.md`. `programs` are what its table names; `build` are the commands of the
 * host, `serves` the folder that a plain server sends then, `start` and `dev` servers of its own. What is written in
 * Python has an environment of its own, with what its `requirements.txt` names.
 */
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";

/** The frame of the studio asks for WebGPU, once. */
const ADAPTERS = /No available adapters/;

export const HOSTS = {
  node: { build: ["node picture.mjs"], after: drawn },
  "vite-react": {
    programs: ["vite", "react"],
    build: ["tsc", "vite build"],
    serves: "dist",
    dev: "vite --port PORT --strictPort",
  },
  webpack: { programs: ["webpack"], build: ["webpack --mode production"], serves: "." },
  esbuild: {
    programs: ["esbuild"],
    build: ["esbuild main.js --bundle --format=esm --splitting --minify --outdir=dist"],
    serves: ".",
  },
  rollup: { programs: ["rollup"], build: ["rollup main.js --plugin node-resolve --dir dist"], serves: "." },
  "import-map": { serves: "." },
  next: {
    programs: ["next", "react"],
    build: ["next build"],
    start: "next start --port PORT",
    dev: "next dev --port PORT",
    also: (page) => page.getByText("The server says: connected").waitFor(),
  },
  astro: {
    programs: ["astro"],
    build: ["astro build"],
    serves: "dist",
    dev: "astro dev --port PORT",
  },
  vue: {
    programs: ["vue", "vite"],
    build: ["vite build"],
    serves: "dist",
    dev: "vite --port PORT --strictPort",
  },
  svelte: {
    programs: ["svelte", "vite"],
    build: ["vite build"],
    serves: "dist",
    dev: "vite --port PORT --strictPort",
  },
  preact: {
    programs: ["preact", "vite"],
    build: ["tsc", "vite build"],
    serves: "dist",
    dev: "vite --port PORT --strictPort",
  },
  bun: {
    programs: ["bun"],
    borrows: ["node/picture.mjs"],
    build: ["bun picture.mjs", "bun build index.html --splitting --outdir=dist"],
    after: drawn,
    serves: "dist",
  },
  deno: {
    programs: ["deno"],
    borrows: ["node/picture.mjs"],
    build: ["deno run --allow-read --allow-write picture.mjs"],
    after: drawn,
  },
  reveal: { programs: ["reveal.js"], serves: ".", studio: true, also: slides, expected: ADAPTERS },
  notebook: {
    programs: ["jupyterlab", "anywidget"],
    python: true,
    start:
      "jupyter lab --allow-root --no-browser --port PORT --ServerApp.port_retries=0 --IdentityProvider.token= " +
      "--LabApp.news_url=",
    // Said of every kernel that listens on this machine.
    usual: /Kernel is running over TCP without encryption/,
    opens: "lab/tree/morph.ipynb",
    first: runs,
  },
  policy: {
    serves: ".",
    headers: {
      "content-security-policy":
        "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; connect-src 'self'; worker-src 'self' blob:; " +
        "require-trusted-types-for 'script'; trusted-types frond frond-pool",
    },
    also: (page) => page.getByText("The pool says: connected").waitFor(),
    output: "The pool says: connected",
  },
};

/** The versions that the project in a folder pins, by name. */
export function pinsOf(folder) {
  const { dependencies } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  const requirements = join(folder, "requirements.txt");
  const lines = existsSync(requirements) ? readFileSync(requirements, "utf8").trim().split("\n") : [];
  return { ...dependencies, ...Object.fromEntries(lines.map((line) => line.split("=="))) };
}

/** The slider has its arrow keys for itself, elsewhere they turn the page, and the next has a picture behind it. */
async function slides(page) {
  const slide = () =>
    page.evaluate(() => document.querySelector(".slides").querySelectorAll("section.past").length);
  const time = page.locator("frond-view").getByRole("slider", { name: "Time" });
  for (const key of ["ArrowRight", "ArrowDown", " "]) await time.press(key);
  if ((await slide()) !== 0) throw new Error("a key of the slider turns the page");
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press("ArrowRight");
  await page.waitForFunction(() => document.querySelectorAll("section.past").length === 1);
  const behind = page.frameLocator("iframe[src*='embed.html']");
  await behind.getByRole("img").or(behind.locator("canvas")).first().waitFor();
}

/** All cells of the notebook. */
async function runs(page) {
  await page.getByText("Python 3 (ipykernel) | Idle").waitFor();
  await page.getByRole("menuitem", { name: "Run", exact: true }).click();
  await page.getByRole("menuitem", { name: "Run All Cells", exact: true }).click();
}

/** Fails unless the program of Node has written its picture, and told its verdict. */
function drawn(app, output) {
  const bytes = readFileSync(join(app, "gasket.pgm"));
  const head = "P5\n400 400\n255\n";
  const pixels = bytes.subarray(head.length);
  if (!bytes.toString("latin1").startsWith(head) || pixels.length !== 400 * 400)
    throw new Error("gasket.pgm is no picture");
  const dark = pixels.filter((byte) => byte < 128).length;
  if (dark < 1000 || dark > pixels.length - 1000)
    throw new Error("there is nothing to be seen in gasket.pgm");
  if (!/^connected$/m.test(output)) throw new Error(`the verdict is not "connected":\n${output}`);
}
