/**
 * `<frond-view>` as the package has it: a module, and what decides and proves in files that it imports when asked. All
 * are plain JavaScript, so that every bundler takes them along, and no address has to be right.
 */
import { defineConfig } from "vite";
import { givenModules, packed, programs, root } from "./element-parts.ts";

/** Bundlers warn of files of more than 250 kB. */
const PARTS = 4;
const PART = /frond-proof\?part=(\d)$/;

const proofInParts = {
  name: "proof-in-parts",
  enforce: "pre" as const,
  resolveId: (id: string) => (PART.test(id) ? `\0${id}` : null),
  load(id: string) {
    const [, part] = PART.exec(id) ?? [];
    if (part === undefined) return null;
    const text = packed("frond-proof_bg.wasm");
    const length = Math.ceil(text.length / PARTS);
    const own = text.slice(length * (Number(part) - 1), length * Number(part));
    return `export const text = ${JSON.stringify(own)};`;
  },
};

/** An address that a page gives while it runs is nothing that a bundler could look for; without a word they warn. */
const IGNORE = "/* @vite-ignore */ /* webpackIgnore: true */ /* turbopackIgnore: true */ ";
const givenAddresses = {
  name: "given-addresses",
  generateBundle(_: unknown, bundle: Record<string, { type: string; code?: string }>) {
    for (const chunk of Object.values(bundle))
      if (chunk.code) chunk.code = chunk.code.replace(/\bimport\((?=\w+\))/g, `import(${IGNORE}`);
  },
};

export default defineConfig({
  root,
  resolve: { tsconfigPaths: true },
  publicDir: false,
  plugins: [proofInParts, givenModules, programs, givenAddresses],
  define: { FROND_MORPH: JSON.stringify(packed("frond-morph_bg.wasm")) },
  build: {
    target: "baseline-widely-available",
    outDir: "target/package/parts",
    emptyOutDir: false,
    reportCompressedSize: false,
    lib: { entry: "www/src/element/module.ts", formats: ["es"], fileName: () => "frond-view.module.js" },
    rolldownOptions: {
      output: {
        chunkFileNames: ({ moduleIds: [id = ""] }) => `frond-view-proof-${PART.exec(id)?.[1] ?? "other"}.js`,
      },
    },
  },
});
