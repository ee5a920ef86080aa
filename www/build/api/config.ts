/** The script of the pages of functions, and each of their samples as a module. */
import { readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { wrapped } from "./wrapped.ts";

const root = fileURLToPath(new URL("../../..", import.meta.url));
const folder = fileURLToPath(new URL("./samples", import.meta.url));
const pkg = (file: string) => fileURLToPath(new URL(`../../pkg/${file}.js`, import.meta.url));
const SAMPLE = "sample:";

const samples = {
  name: "samples",
  enforce: "pre" as const,
  resolveId: (id: string) => (id.startsWith(SAMPLE) ? `\0${id}` : null),
  load: (id: string) =>
    id.startsWith(`\0${SAMPLE}`)
      ? wrapped(readFileSync(`${folder}/${id.slice(SAMPLE.length + 1)}.js`, "utf8"))
      : null,
};

export default defineConfig({
  root,
  base: "./",
  publicDir: false,
  plugins: [samples],
  resolve: {
    alias: [
      { find: /^frond-ifs$/, replacement: pkg("index") },
      { find: /^frond-ifs\/draw$/, replacement: pkg("frond") },
      { find: /^frond-ifs\/(\w+)$/, replacement: pkg("frond-$1") },
    ],
  },
  build: {
    target: "baseline-widely-available",
    outDir: "dist",
    emptyOutDir: false,
    reportCompressedSize: false,
    // The files that the studio has, too.
    assetsInlineLimit: (file) => (file.endsWith(".wasm") ? false : undefined),
    modulePreload: { polyfill: false },
    rolldownOptions: {
      preserveEntrySignatures: "strict",
      input: Object.fromEntries([
        ["api", "www/build/api/script.ts"],
        ...readdirSync(folder).map((file) => {
          const name = file.replace(/\.js$/, "");
          return [`samples/${name}`, `${SAMPLE}${name}`];
        }),
      ]),
      output: { entryFileNames: "api/[name].js", chunkFileNames: "api/[name]-[hash].js" },
    },
  },
});
