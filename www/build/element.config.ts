/** `<frond-view>` as one script that needs nothing beside it: its worker, its styles and its module are inside. */
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { defineConfig } from "vite";

const root = fileURLToPath(new URL("../..", import.meta.url));
const pkg = (name: string) => readFileSync(new URL(`../pkg/${name}`, import.meta.url));

/** The bindings would look for the module beside the script: it is given to them. */
const givenModule = {
  name: "given-module",
  enforce: "pre" as const,
  transform: (code: string, id: string) =>
    id.endsWith("/frond-morph.js")
      ? { code: code.replace(/new URL\('[^']+\.wasm', import\.meta\.url\)/, "undefined"), map: null }
      : null,
};

/** What decides and proves lies beside it, for elements that are asked whether they hold together. */
const proofBeside = {
  name: "proof-beside",
  generateBundle(this: { emitFile(file: { type: "asset"; fileName: string; source: Uint8Array }): void }) {
    for (const fileName of ["frond-proof.js", "frond-proof_bg.wasm"])
      this.emitFile({ type: "asset", fileName, source: pkg(fileName) });
  },
};

export default defineConfig({
  root,
  resolve: { tsconfigPaths: true },
  publicDir: false,
  plugins: [givenModule, proofBeside],
  define: {
    FROND_MORPH: JSON.stringify(gzipSync(pkg("frond-morph_bg.wasm"), { level: 9 }).toString("base64")),
  },
  worker: { format: "iife", plugins: () => [givenModule] },
  build: {
    target: "baseline-widely-available",
    outDir: "dist",
    emptyOutDir: false,
    reportCompressedSize: false,
    // A plain script: it works from a file, too, where modules are refused.
    lib: {
      entry: "www/src/element/element.ts",
      formats: ["iife"],
      name: "Frond",
      fileName: () => "frond-view.js",
    },
  },
});
