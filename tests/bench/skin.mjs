// Moving the mesh in wasm: a million points by their weights, against the formula point by point, in one run.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../..", import.meta.url));
const target = `${root}target/bench-skin`;
// From the root, so that the features of .cargo/config.toml are those of the page's module.
execFileSync(
  "cargo",
  [
    "build",
    "--lib",
    "--quiet",
    "--release",
    "--target",
    "wasm32-unknown-unknown",
    "--manifest-path",
    "tests/bench/skin/Cargo.toml",
  ],
  { cwd: root, env: { ...process.env, CARGO_TARGET_DIR: target }, stdio: "inherit" },
);
const bytes = readFileSync(`${target}/wasm32-unknown-unknown/release/frond_skin.wasm`);
const { prepare, follow, formula, tree } = (await WebAssembly.instantiate(bytes, {})).instance.exports;

/** Milliseconds: the least of some runs. */
function least(runs, run) {
  let best = Number.POSITIVE_INFINITY;
  for (let i = 0; i < runs; i++) {
    const start = performance.now();
    run(i);
    best = Math.min(best, performance.now() - start);
  }
  return best;
}

const POINTS = 1_000_000;
prepare(POINTS);
const skinned = least(20, (i) => follow(0.001 * i));
const pointwise = least(3, () => formula(POINTS / 20)) * 20;
console.log(
  `10^6 points in wasm, ke 9: skin ${skinned.toFixed(2)} ms, formula ${pointwise.toFixed(0)} ms: ${(pointwise / skinned).toFixed(0)} times as fast`,
);
for (const ke of [9, 12]) {
  console.log(`all cells of the gasket in wasm, ke ${ke}: ${least(5, () => tree(ke)).toFixed(1)} ms`);
}
