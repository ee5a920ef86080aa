// A module for Node, whose fetch() opens no files: without an argument, it is read from the folder above.
import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import load from "../MODULE.js";

export * from "../MODULE.js";

export default function init(input) {
  return load(
    input ?? { module_or_path: readFile(fileURLToPath(new URL("../MODULE_bg.wasm", import.meta.url))) },
  );
}
