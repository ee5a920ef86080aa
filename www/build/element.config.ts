/** `<frond-view>` as one script that needs nothing beside it: its worker, its styles and its module are inside. */
import { defineConfig } from "vite";
import { givenModules, packed, pkg, programs, root } from "./element-parts.ts";

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
  plugins: [givenModules, programs, proofBeside],
  define: { FROND_MORPH: JSON.stringify(packed("frond-morph_bg.wasm")) },
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
