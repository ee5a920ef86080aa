import { createHash } from "node:crypto";
import { existsSync, readFileSync } from "node:fs";
import { dirname, join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";
import { licenses } from "./www/build/licenses.ts";
import { notation } from "./www/build/notation.ts";
import { pages as sitePages } from "./www/build/pages.ts";
import { securityPolicy } from "./www/build/policy.ts";
import { bill } from "./www/build/sbom.ts";

/** Pages of the site, each of which becomes a file of its own in dist/. */
const pages = ["index.html", "embed.html", "figures/index.html"].filter((page) => existsSync(page));

const root = fileURLToPath(new URL(".", import.meta.url));

/** In the built site class names are short; while one works on it, they stay as the sheet's other lines change. */
let building = false;

/** What the names of a sheet have in common, and which sheet has that. */
const owners = new Map<string, string>();

/** What a class of a module is called on the page. */
function scopedName(name: string, sheet: string): string {
  const file = sheet.replace(/\?.*/, "");
  const path = relative(root, file).replaceAll("\\", "/");
  const mark = createHash("sha256").update(path).digest("base64url").slice(0, 3);
  const owner = owners.get(mark) ?? path;
  if (owner !== path)
    throw new Error(`${path} needs another name: its classes would be called as those of ${owner}`);
  owners.set(mark, path);
  if (!building) return `${name}-${mark}`;
  const names = [...readFileSync(file, "utf8").matchAll(/\.([a-z][\w-]*)/g)].map(([, one]) => one);
  const index = [...new Set(names)].indexOf(name);
  // Plain sheets have no capitals.
  return `${String.fromCharCode(65 + (index % 26))}${index < 26 ? "" : Math.floor(index / 26)}${mark}`;
}

/** Writes the names of classes where they are asked for, `css["name"]`, so that no table of them is downloaded. */
const classNames = {
  name: "class-names",
  enforce: "pre" as const,
  configResolved({ command }: { command: string }) {
    building = command === "build";
  },
  transform(code: string, id: string) {
    if (!/\.tsx?$/.test(id)) return null;
    let written = code;
    for (const [whole, table = "", from = ""] of code.matchAll(
      /import (\w+) from "([^"]+\.module\.css)";/g,
    )) {
      const sheet = from.startsWith("#") ? join(root, "www/src", from.slice(1)) : join(dirname(id), from);
      written = written.replace(new RegExp(`\\b${table}\\["([\\w-]+)"\\]`, "g"), (_, name) =>
        JSON.stringify(scopedName(name, sheet)),
      );
      // Names that are chosen while the page runs are still looked up.
      if (!written.includes(`${table}[`)) written = written.replace(whole, `import "${from}";`);
    }
    return written === code ? null : { code: written, map: null };
  },
};

/** Keeps the styles of a module on the page though nothing asks for its table any more. */
const used = "globalThis.styles;";
const keptStyles = {
  name: "kept-styles",
  enforce: "post" as const,
  transform: (code: string, id: string) =>
    id.endsWith(".module.css") ? { code: `${code}\n${used}`, map: null, moduleSideEffects: true } : null,
  renderChunk: (code: string) => code.replaceAll(used, ""),
};

/**
 * Gives each file its own copy of the messages that it says: what only a later chunk says is no part of the first
 * script. Without it, a catalogue lies whole in the first chunk that says anything of it.
 */
const ownMessages = {
  name: "own-messages",
  apply: "build" as const,
  enforce: "pre" as const,
  async resolveId(this: Resolver, source: string, importer: string | undefined) {
    if (!importer || !/^[.#].*\/messages$/.test(source)) return null;
    const found = await this.resolve(source, importer, { skipSelf: true });
    const reader = createHash("sha256").update(relative(root, importer)).digest("hex").slice(0, 8);
    return found ? `${found.id}?by=${reader}` : null;
  },
};

interface Resolver {
  resolve(source: string, importer: string, options: { skipSelf: boolean }): Promise<{ id: string } | null>;
}

export default defineConfig({
  // Relative addresses: the built site works from any folder of a plain static host.
  base: "./",
  // No fallback to index.html: a missing file is a missing file, as on that host.
  appType: "mpa",
  resolve: { tsconfigPaths: true },
  publicDir: "www/public",
  plugins: [ownMessages, notation, classNames, keptStyles, sitePages, licenses, bill, securityPolicy],
  css: { modules: { generateScopedName: scopedName } },
  worker: { format: "es" },
  build: {
    target: "baseline-widely-available",
    outDir: "dist",
    emptyOutDir: true,
    // The size gate of `cargo xtask test` does this, and fails.
    reportCompressedSize: false,
    // The module is a file that the workers share, however small.
    assetsInlineLimit: (file) => (file.endsWith(".wasm") ? false : undefined),
    modulePreload: { polyfill: false },
    rolldownOptions: {
      input: pages,
      // A message is written where it is said, so that a chunk has its own alone.
      optimization: { inlineConst: { mode: "all", pass: 1 } },
      output: {
        // The first script names all the others: short names make it 0.8 kB smaller. Tests take pages of
        // figures and modules away by name, and the size gate weighs modules by it.
        chunkFileNames: ({ name }) =>
          /^(page$|frond)/.test(name) ? "assets/[name]-[hash].js" : "assets/[hash].js",
        assetFileNames: ({ names }) =>
          `assets/${names.some((name) => name.endsWith(".css")) ? "[hash]" : "[name]-[hash]"}[extname]`,
        codeSplitting: {
          groups: [
            // What a page loads at once is one file, however much of it is shared with what it loads later.
            { name: "first", tags: ["$initial"] },
            // What figures share is one file for the kit, and one a paper. The small pictures of a paper are in no group: what
            // they alone have would stay outside of it, and be there too late for them.
            {
              name: (path) => /src\/figures\/([\w-]+)\//.exec(path)?.[1] ?? null,
              test: /src\/figures\//,
              minShareCount: 2,
              includeDependenciesRecursively: false,
            },
          ],
        },
      },
    },
  },
  server: {
    // The wasm package is watched through www/pkg, which `cargo xtask serve` writes anew.
    watch: { ignored: ["**/target/**", "**/crate/**", "**/dist/**", "**/tests/**"] },
  },
  test: {
    // No test is about time: a busy machine may take as long as it needs.
    testTimeout: 60_000,
    include: ["www/src/**/*.test.{ts,tsx}", "tests/api/**/*.test.ts"],
    environment: "node",
    // Each file has a thread of its own: as much apart as processes are for what is tested here, and sooner there.
    pool: "threads",
    restoreMocks: true,
  },
});
