/** `<frond-view>` as the package has it, in pages with keys, frameworks and policies of their own. */
import { readFile } from "node:fs/promises";
import { createServer, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, test } from "./fixture";

const built = fileURLToPath(new URL("../../target/package/frond/", import.meta.url));
const TYPES: Readonly<Record<string, string>> = { ".js": "text/javascript", ".wasm": "application/wasm" };

type Host = Window & { heard: [id: string, type: string, detail: { message?: string }][]; keys: string[] };

let server: Server;
let [markup, policy] = ["", ""];

test.beforeAll(async () => {
  server = createServer(async ({ url = "/" }, response) => {
    const path = new URL(url, "http://here/").pathname;
    if (policy) response.setHeader("content-security-policy", policy);
    if (path === "/") {
      response
        .setHeader("content-type", "text/html")
        .end(`<!doctype html><html lang="en"><title>A host</title>
        <link rel="icon" href="data:," /><script type="module" src="host.js"></script>${markup}</html>`);
      return;
    }
    const file = path === "/host.js" ? Promise.resolve(HOST) : readFile(join(built, normalize(path)));
    response.setHeader("content-type", TYPES[extname(path)] ?? "text/plain");
    response.end(await file);
  });
  await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
});

test.afterAll(() => {
  server.close();
  server.closeAllConnections();
});

const HOST = `
  window.heard = [];
  window.keys = [];
  for (const type of ["ready", "verdict", "error"])
    addEventListener(type, ({ target, detail }) => target.id && heard.push([target.id, type, detail]), true);
  for (const type of ["keydown", "keyup"])
    document.addEventListener(type, ({ key }) => keys.push(type + " " + key));
  await import("./frond-view.module.js");`;

const open = async (page: import("@playwright/test").Page, content: string, allowed = "") => {
  [markup, policy] = [content, allowed];
  await page.goto(`http://127.0.0.1:${(server.address() as AddressInfo).port}/`);
};
const heard = (page: import("@playwright/test").Page) =>
  page.evaluate(() => (window as unknown as Host).heard);

const MORPH = `<frond-view id="morph" a="dragon-3" b="gasket" t="0.4" controls verdict></frond-view>`;

test("keeps the keys that it answers from the page around", async ({ page }) => {
  await open(page, MORPH);
  const time = page.getByRole("slider", { name: "Time" });
  for (const key of ["ArrowRight", "ArrowLeft", "Home", "PageUp", " ", "a", "Escape", "Control+ArrowLeft"])
    await time.press(key);
  await page.getByRole("button", { name: /Play|Pause/ }).press("Enter");
  const keys = await page.evaluate(() => (window as unknown as Host).keys);
  expect(keys.filter((key) => !/Control/.test(key))).toEqual([
    "keydown a",
    "keyup a",
    "keydown Escape",
    "keyup Escape",
    "keydown ArrowLeft",
    "keyup ArrowLeft",
  ]);
});

test("takes what frameworks write, and tells once what means nothing", async ({ page }) => {
  await open(page, `<frond-view id="wrong" a="fern" t="soon" theme="blue" path="there"></frond-view>`);
  await expect(page.getByRole("img", { name: "Fern" })).toBeVisible();
  // It is shown all the same, with a word in a corner.
  await expect(page.getByRole("alert")).toHaveText("t is a number from 0 to 1.");
  const seen = await page.evaluate(async () => {
    type Properties = HTMLElement & Record<string, unknown>;
    const view = document.getElementById("wrong") as Properties;
    for (let i = 0; i < 3; i++) Object.assign(view, { t: "soon", theme: "blue", seconds: "long" });
    await null;
    const other = document.createElement("frond-view") as HTMLElement as Properties;
    const written: Record<string, unknown> = {};
    for (const [name, values] of Object.entries({
      t: [0.25, "0.5", null],
      seconds: [4, "900", "", null],
      controls: [true, "false", "", undefined],
      loop: ["true", false],
      locus: [1, 0],
      verdict: [true, false, ""],
      a: [
        [
          [0.5, 0, 0, 0.5, 0, 0],
          [0.5, 0, 0, 0.5, 0.5, 0],
        ],
        "fern",
        null,
      ],
      path: [[[0.1, 0.8]], "auto"],
      label: ["Mine", 5, null],
    }))
      written[name] = values.map((value) => {
        other[name] = value;
        return [name === "verdict" ? typeof other[name] : other[name], other.getAttribute(name)];
      });
    const set = (() => {
      try {
        (view.constructor as unknown as { proof: unknown }).proof = 5;
      } catch (problem) {
        const { name, code } = problem as { name: string; code: string };
        return [problem instanceof Error, name, code];
      }
      return null;
    })();
    return { written, set };
  });
  expect(seen).toEqual({
    written: {
      t: [
        [0.25, "0.25"],
        [0.5, "0.5"],
        [0, null],
      ],
      seconds: [
        [4, "4"],
        [600, "900"],
        [8, ""],
        [8, null],
      ],
      controls: [
        [true, ""],
        [false, null],
        [true, ""],
        [false, null],
      ],
      loop: [
        [true, ""],
        [false, null],
      ],
      locus: [
        [true, ""],
        [false, null],
      ],
      verdict: [
        ["function", ""],
        ["function", null],
        ["function", ""],
      ],
      a: [
        ["[[0.5,0,0,0.5,0,0],[0.5,0,0,0.5,0.5,0]]", "[[0.5,0,0,0.5,0,0],[0.5,0,0,0.5,0.5,0]]"],
        ["fern", "fern"],
        [null, null],
      ],
      path: [
        ["0.1,0.8", "0.1,0.8"],
        ["auto", "auto"],
      ],
      label: [
        ["Mine", "Mine"],
        ["5", "5"],
        [null, null],
      ],
    },
    set: [true, "FrondError", "proof"],
  });
  const errors = (await heard(page)).filter(([, type]) => type === "error");
  expect(errors.map(([, , { message }]) => message?.split(" ")[0]).sort()).toEqual([
    "path",
    "seconds",
    "t",
    "theme",
  ]);
});

test("shows the straight way while a path is sought, and stays at the moment when it is found", async ({
  page,
}) => {
  await open(page, MORPH);
  await expect.poll(async () => (await heard(page)).map(([, type]) => type)).toEqual(["ready", "verdict"]);
  await expect(page.getByText("In one piece, proved")).toBeVisible();
  expect(await page.evaluate(() => (document.getElementById("morph") as unknown as { t: number }).t)).toBe(
    0.4,
  );
});

const STRICT = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; img-src data:";

test.describe("under a strict policy", () => {
  test.use({ expected: /Content Security Policy|requires 'TrustedScriptURL'|Content Security policy/ });
  for (const [name, allowed, workers] of [
    ["that knows its policy, in workers", "worker-src blob:; trusted-types frond", 2],
    ["that does not, without workers", "worker-src blob:; trusted-types other", 0],
    ["that forbids workers, without them", "worker-src 'none'; trusted-types frond", 0],
  ] as const)
    test(`draws and decides on a page ${name}`, async ({ page }) => {
      await open(page, MORPH, `${STRICT}; require-trusted-types-for 'script'; ${allowed}`);
      await expect(page.getByText("In one piece, proved")).toBeVisible();
      expect(page.workers().length).toBe(workers);
    });

  test("lets the package's pool work as well", async ({ page }) => {
    const allowed = `${STRICT}; connect-src 'self'; worker-src 'self'; require-trusted-types-for 'script'`;
    await open(page, "", `${allowed}; trusted-types frond-pool`);
    const verdict = await page.evaluate(async () => {
      const module = new URL("./pool.js", location.href).href;
      const { createPool }: typeof import("../../crate/xtask/src/package/entries/pool.js") = await import(
        module
      );
      const pool = createPool({ size: 1 });
      const maps = [
        [0.3, 0, 0, 0.3, 0, 0],
        [0.3, 0, 0, 0.3, 0.7, 0],
      ];
      const found = await pool.connectedness({ maps } as never, undefined);
      pool.close();
      return found.verdict;
    });
    expect(verdict).toBe("disconnected");
  });
});
