// The entry for Node, whose fetch() opens no files: without an argument, the modules are read from the folder above.
import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import load from "../index.js";

export * from "../index.js";

const above = (name) => readFile(fileURLToPath(new URL(`../${name}`, import.meta.url)));

export default async function init({ frond, curve, proof } = {}) {
  await load({
    frond: frond ?? (await above("frond_bg.wasm")),
    curve: curve ?? (await above("frond-curve_bg.wasm")),
    proof: proof ?? (await above("frond-proof_bg.wasm")),
  });
}
