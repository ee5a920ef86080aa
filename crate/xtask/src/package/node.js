// The entry for Node, whose fetch() opens no files: without an argument, the module is read from beside this file.
import { readFile } from "node:fs/promises";
import init from "./frond.js";

export * from "./frond.js";

export default async function load(options) {
  return init(options ?? { module_or_path: await readFile(new URL("./frond_bg.wasm", import.meta.url)) });
}
