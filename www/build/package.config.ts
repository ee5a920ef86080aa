/** The parts of the package that share code with the page; `crate/xtask/src/package.rs` puts them there. */
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

export default defineConfig({
  root: fileURLToPath(new URL("../..", import.meta.url)),
  resolve: { tsconfigPaths: true },
  publicDir: false,
  build: {
    target: "baseline-widely-available",
    outDir: "target/package/parts",
    reportCompressedSize: false,
    lib: {
      entry: {
        "pool-lanes": "www/src/package/pool.ts",
        command: "www/src/package/command/command.ts",
        "command-lanes": "www/src/package/command/worker.ts",
      },
      formats: ["es"],
    },
  },
});
