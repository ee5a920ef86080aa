// The entry for Node, whose fetch() opens no files: without an argument, the modules are read from the folder above.
import load from "../index.js";
import { read } from "./read.js";

export * from "../index.js";

const above = (name) => read(new URL(`../${name}`, import.meta.url), name);

export default async function init({ frond, curve, proof } = {}) {
  await load({
    frond: frond ?? (await above("frond_bg.wasm")),
    curve: curve ?? (await above("frond-curve_bg.wasm")),
    proof: proof ?? (await above("frond-proof_bg.wasm")),
  });
}
