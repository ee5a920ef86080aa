// A module for Node, whose fetch() opens no files: without an argument, it is read from the folder above.
import load from "../MODULE.js";
import { read } from "./read.js";

export * from "../MODULE.js";

export default function init(input) {
  return load(
    input ?? { module_or_path: read(new URL("../MODULE_bg.wasm", import.meta.url), "MODULE_bg.wasm") },
  );
}
