/** What both builds of `<frond-view>` share: the script of a plain page, and the module that programs import. */
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { build } from "vite";

export const root = fileURLToPath(new URL("../..", import.meta.url));

export const pkg = (name: string) => readFileSync(new URL(`../pkg/${name}`, import.meta.url));

/** A module as a text, to be packed into a script. */
export const packed = (name: string) => gzipSync(pkg(name), { level: 9 }).toString("base64");

/** The bindings would look for their module beside the script: it is given to them. */
export const givenModules = {
  name: "given-modules",
  enforce: "pre" as const,
  transform: (code: string, id: string) =>
    /\/frond-(morph|proof)\.js$/.test(id)
      ? { code: code.replace(/new URL\('[^']+\.wasm', import\.meta\.url\)/, "undefined"), map: null }
      : null,
};

/** `?program`: a worker as the text of its program, so that it starts from no address and under any policy. */
export const programs = {
  name: "programs",
  enforce: "pre" as const,
  async load(id: string) {
    const [file = "", query] = id.split("?");
    if (query !== "program") return null;
    const made = await build({
      configFile: false,
      root,
      logLevel: "warn",
      resolve: { tsconfigPaths: true },
      publicDir: false,
      plugins: [givenModules],
      build: {
        target: "baseline-widely-available",
        write: false,
        lib: { entry: file, formats: ["iife"], name: "Worker", fileName: () => "worker.js" },
      },
    });
    const outputs = (Array.isArray(made) ? made : [made]).flatMap((one) =>
      "output" in one ? one.output : [],
    );
    const [chunk] = outputs.filter((output) => output.type === "chunk");
    if (!chunk) throw new Error(`${file} made no program.`);
    return `export default ${JSON.stringify(chunk.code)};`;
  },
};
