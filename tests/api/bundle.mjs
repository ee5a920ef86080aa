/**
 * Bundles a program that uses the package as its README says: `node bundle.mjs BUNDLER FOLDER`, of a folder with
 * app.js, index.html and the package in node_modules. What is made lies in FOLDER/out/BUNDLER.
 */
import { cpSync, mkdirSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const [bundler = "", folder = ""] = process.argv.slice(2);
const out = join(folder, "out", bundler);
const installed = join(folder, "node_modules/frond-ifs");

const page = (script) => writeFileSync(join(out, "index.html"), `<!doctype html>${script}`);

/** Some leave the modules to whoever calls them. */
function copyModules() {
  for (const name of readdirSync(installed))
    if (name.endsWith(".wasm")) cpSync(join(installed, name), join(out, name));
}

async function webpacked(target) {
  const { default: webpack } = await import("webpack");
  const options = {
    mode: "production",
    context: folder,
    entry: "./app.js",
    target,
    output: { path: out },
    // As the README has it.
    performance: { maxAssetSize: 2_000_000, maxEntrypointSize: 500_000 },
  };
  const stats = await new Promise((resolve, reject) =>
    webpack(options, (problem, found) => (problem ? reject(problem) : resolve(found))),
  );
  if (stats.hasErrors() || stats.hasWarnings()) throw new Error(stats.toString("errors-warnings"));
}

const BUNDLERS = {
  async vite() {
    const { build } = await import("vite");
    await build({
      configFile: false,
      logLevel: "warn",
      root: folder,
      base: "./",
      worker: { format: "es" },
      build: { outDir: out },
    });
  },
  async webpack() {
    await webpacked("web");
    page('<script src="main.js"></script>');
  },
  async "webpack-node"() {
    await webpacked("node");
    writeFileSync(join(out, "package.json"), '{ "type": "commonjs" }');
  },
  async esbuild() {
    const { build } = await import("esbuild");
    await build({
      absWorkingDir: folder,
      entryPoints: ["app.js", "frond-ifs/pool-worker.js"],
      entryNames: "[name]",
      bundle: true,
      format: "esm",
      outdir: out,
      logLevel: "warning",
    });
    copyModules();
    page('<script type="module" src="app.js"></script>');
  },
  async "esbuild-loader"() {
    const { build } = await import("esbuild");
    await build({
      absWorkingDir: folder,
      entryPoints: ["loader.js"],
      loader: { ".wasm": "file" },
      bundle: true,
      format: "esm",
      outdir: out,
      logLevel: "warning",
    });
    page('<script type="module" src="loader.js"></script>');
  },
  async rolldown() {
    const { rolldown } = await import("rolldown");
    const bundle = await rolldown({
      cwd: folder,
      input: { app: "./app.js", "pool-worker": "frond-ifs/pool-worker.js" },
      platform: "browser",
    });
    await bundle.write({ dir: out });
    copyModules();
    page('<script type="module" src="app.js"></script>');
  },
};

mkdirSync(out, { recursive: true });
await BUNDLERS[bundler]();
