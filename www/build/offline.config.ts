/** The service worker of the site, built after all else: it is another one whenever any file of the site is. */
import { createHash } from "node:crypto";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

const root = fileURLToPath(new URL("../..", import.meta.url));
const dist = join(root, "dist");

function build(): string {
  const hash = createHash("sha256");
  // What stands in assets/ has the hash of its content in its name.
  for (const name of readdirSync(join(dist, "assets")).sort()) hash.update(name);
  for (const page of ["index.html", "embed.html"]) hash.update(readFileSync(join(dist, page)));
  return hash.digest("base64url").slice(0, 12);
}

export default defineConfig(() => ({
  root,
  resolve: { tsconfigPaths: true },
  publicDir: false as const,
  define: { FROND_BUILD: JSON.stringify(build()) },
  build: {
    target: "baseline-widely-available" as const,
    outDir: "dist",
    emptyOutDir: false,
    reportCompressedSize: false,
    lib: { entry: "www/src/offline/sw.ts", formats: ["iife" as const], name: "sw", fileName: () => "sw.js" },
  },
}));
