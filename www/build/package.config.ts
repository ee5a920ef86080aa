/**
 * The parts of the package that share code with the page, and its modules as they are shipped;
 * `crate/xtask/src/package.rs` puts them there.
 */
import { resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { defineConfig, type Plugin } from "vite";
import { ship } from "./package/ship.ts";

/** Beside the parts. */
function modules(): Plugin {
  let root = "";
  let folder = "";
  return {
    name: "frond-modules",
    configResolved(config) {
      root = config.root;
      folder = resolve(root, config.build.outDir);
    },
    closeBundle() {
      ship(resolve(root, "www/pkg"), folder);
    },
  };
}

export default defineConfig({
  root: fileURLToPath(new URL("../..", import.meta.url)),
  resolve: { tsconfigPaths: true },
  plugins: [modules()],
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
