// All that needs no graphics card and is done at once: what describes and draws (frond.js), closed curves and graphs
// (frond-curve.js), and what decides and proves (frond-proof.js). Each may be had alone, as frond-ifs/draw,
// frond-ifs/curve and frond-ifs/proof, with an init() of its own; so may what traces and fits, as frond-ifs/fit.
import loadFrond, { initSync as startFrond } from "./frond.js";
import loadCurve, { initSync as startCurve } from "./frond-curve.js";
import loadProof, { initSync as startProof } from "./frond-proof.js";

export * from "./frond.js";
export { start } from "./frond.js";
export * from "./frond-curve.js";
export * from "./frond-proof.js";

export default async function init({ frond, curve, proof } = {}) {
  await Promise.all([
    loadFrond({ module_or_path: frond }),
    loadCurve({ module_or_path: curve }),
    loadProof({ module_or_path: proof }),
  ]);
}

export function initSync({ frond, curve, proof }) {
  startFrond({ module: frond });
  startCurve({ module: curve });
  startProof({ module: proof });
}
