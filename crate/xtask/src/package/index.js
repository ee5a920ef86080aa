// All that needs no graphics card: what describes and draws (frond.js), and what decides and proves (frond-proof.js).
// Each may be had alone, as frond/draw and frond/proof, with an init() of its own.
import loadFrond, { initSync as startFrond } from "./frond.js";
import loadProof, { initSync as startProof } from "./frond-proof.js";

export * from "./frond.js";
export { start } from "./frond.js";
export * from "./frond-proof.js";

export default async function init({ frond, proof } = {}) {
  await Promise.all([loadFrond({ module_or_path: frond }), loadProof({ module_or_path: proof })]);
}

export function initSync({ frond, proof }) {
  startFrond({ module: frond });
  startProof({ module: proof });
}
