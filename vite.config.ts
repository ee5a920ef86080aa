import { existsSync } from "node:fs";
import { defineConfig } from "vitest/config";

/** Pages of the site, each of which becomes a file of its own in dist/. */
const pages = ["index.html", "figures/index.html"].filter((page) => existsSync(page));

export default defineConfig({
  // Relative addresses: the built site works from any folder of a plain static host.
  base: "./",
  // No fallback to index.html: a missing file is a missing file, as on that host.
  appType: "mpa",
  resolve: { tsconfigPaths: true },
  publicDir: "www/public",
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
      output: {
        codeSplitting: {
          groups: [
            // What a page loads at once is one file, however much of it is shared with what it loads later.
            { name: "first", tags: ["$initial"] },
            // All small pictures of figures are shown together. What figures share is one file for the kit, and one a paper.
            { name: "thumbs", test: /src\/figures\/.*\/thumb\.tsx$/, includeDependenciesRecursively: false },
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
    restoreMocks: true,
  },
});
