// The entry for Node, whose fetch() opens no files: without an argument, the modules are read from beside this file.
import { readFile } from "node:fs/promises";
import load from "./index.js";

export * from "./index.js";

const beside = (name) => readFile(new URL(`./${name}`, import.meta.url));

export default async function init({ frond, curve, proof } = {}) {
  await load({
    frond: frond ?? (await beside("frond_bg.wasm")),
    curve: curve ?? (await beside("frond-curve_bg.wasm")),
    proof: proof ?? (await beside("frond-proof_bg.wasm")),
  });
}
