/** Ten lines that use the package, bundled by what others bundle with, each as the package's README says. */
import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, test } from "./fixture";

const root = fileURLToPath(new URL("../../", import.meta.url));
const folder = mkdtempSync(join(tmpdir(), "frond-bundles-"));

const APP = `
  import init, { presets, rasterize } from "frond-ifs/draw";
  import { createPool } from "frond-ifs/pool";
  import "frond-ifs/view";
  await init();
  const fern = presets().find(({ id }) => id === "fern");
  const pixels = rasterize(fern, { width: 30, height: 30 });
  const pool = createPool({ size: 1 });
  const { verdict } = await pool.connectedness(fern);
  pool.close();
  // Between them there is a way that holds together, which is sought by what the element brings along.
  const view = document.createElement("frond-view");
  Object.assign(view, { a: "dragon-3", b: "gasket", t: "0.4" });
  document.body.append(view);
  await new Promise((resolve) => view.addEventListener("ready", resolve));
  const told = await view.verdict();
  document.title = pixels.some((byte) => byte > 0) + " " + verdict + " " + told.verdict;`;
const LOADER = `
  import init, { presets } from "frond-ifs/draw";
  import wasm from "frond-ifs/frond_bg.wasm";
  await init({ module_or_path: wasm });
  document.title = String(presets().length > 10);`;

test.beforeAll(() => {
  const installed = join(folder, "node_modules/frond-ifs");
  mkdirSync(installed, { recursive: true });
  // As it is published: what the manifest leaves out is not there.
  const pack = ["pack", "--json", "--pack-destination", folder];
  const [{ filename }] = JSON.parse(
    execFileSync("npm", pack, { cwd: join(root, "target/package/frond") }).toString(),
  );
  execFileSync("tar", ["-xzf", join(folder, filename), "-C", installed, "--strip-components=1"]);
  writeFileSync(join(folder, "package.json"), '{ "type": "module" }');
  writeFileSync(join(folder, "app.js"), APP);
  writeFileSync(join(folder, "loader.js"), LOADER);
  writeFileSync(join(folder, "index.html"), '<!doctype html><script type="module" src="./app.js"></script>');
});

test.afterAll(() => rmSync(folder, { recursive: true, force: true }));

for (const bundler of ["vite", "webpack", "esbuild", "esbuild-loader", "rolldown"])
  test(`the package works in a bundle by ${bundler}`, async ({ page, baseURL }) => {
    execFileSync(process.execPath, [join(root, "tests/api/bundle.mjs"), bundler, folder]);
    // Somewhere else, so that nothing is found in the package itself.
    const served = join(folder, "served");
    cpSync(join(folder, "out", bundler), join(served, bundler), { recursive: true });
    await page.route("**/bundled/**", (route) => {
      const path = new URL(route.request().url()).pathname.split("/bundled/")[1] ?? "";
      return route.fulfill({
        path: join(served, normalize(path.endsWith("/") ? `${path}index.html` : path)),
      });
    });
    await page.goto(`${baseURL}bundled/${bundler}/`);
    await expect
      .poll(() => page.title())
      .toBe(bundler === "esbuild-loader" ? "true" : "true touching connected");
  });
