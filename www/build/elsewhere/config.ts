/** The programs of "Use it elsewhere", built of the texts that the page shows. */
import { fileURLToPath } from "node:url";
import { defineConfig, transformWithOxc } from "vite";
import { PROGRAMS } from "./ways.ts";

const root = fileURLToPath(new URL("../../..", import.meta.url));

/** Cells as an Observable notebook has them, each as a function of what it names. */
export function cells(text: string): string {
  const [slider = "", view = "", joined = ""] = text.split("\n\n");
  return [
    slider.replace(/^viewof t = (.*)$/s, "export const slider = ({ Inputs }) => $1;"),
    view.replace(/^view = /, "export const view = async ({ require, html }) => "),
    `export const join = ({ view, t }) => ${joined};`,
  ].join("\n");
}

const TEXTS: Readonly<Record<string, () => string | Promise<string>>> = {
  "example:draw": () => PROGRAMS.draw,
  "example:observable": () => cells(PROGRAMS.observable),
  "example:react": async () =>
    (await transformWithOxc(PROGRAMS.react, "react.jsx", { jsx: { runtime: "automatic" } })).code,
  // The page has the element already.
  "frond-ifs/view": () => "",
};

/** What the texts name, as whoever installs it would find it. */
const examples = {
  name: "examples",
  enforce: "pre" as const,
  resolveId: (id: string) => (id in TEXTS ? `\0${id}` : null),
  load: (id: string) => TEXTS[id.slice(1)]?.() ?? null,
};

export default defineConfig({
  root,
  base: "./",
  publicDir: false,
  plugins: [examples],
  resolve: {
    alias: {
      "frond-ifs/draw": fileURLToPath(new URL("../../pkg/frond.js", import.meta.url)),
      "react/jsx-runtime": "preact/jsx-runtime",
      react: "preact/compat",
    },
  },
  build: {
    target: "baseline-widely-available",
    outDir: "dist",
    emptyOutDir: false,
    reportCompressedSize: false,
    // The file that the studio has, too.
    assetsInlineLimit: (file) => (file.endsWith(".wasm") ? false : undefined),
    modulePreload: { polyfill: false },
    rolldownOptions: {
      input: {
        draw: "example:draw",
        observable: "www/build/elsewhere/observable.ts",
        react: "www/build/elsewhere/react.tsx",
      },
      output: { entryFileNames: "elsewhere/[name].js", chunkFileNames: "elsewhere/[name]-[hash].js" },
    },
  },
});
