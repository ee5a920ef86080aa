// The chaos game in wasm beside the native one, one thread each, in one run.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../..", import.meta.url));
const target = `${root}target/bench-chaos`;
// From the root, so that the features of .cargo/config.toml are those of the page's module.
const cargo = (...args) =>
  execFileSync(
    "cargo",
    [...args, "--quiet", "--release", "--manifest-path", "tests/bench/chaos/Cargo.toml"],
    {
      cwd: root,
      env: { ...process.env, CARGO_TARGET_DIR: target },
      encoding: "utf8",
    },
  );

cargo("build", "--lib", "--target", "wasm32-unknown-unknown");
const bytes = readFileSync(`${target}/wasm32-unknown-unknown/release/frond_chaos.wasm`);
const { instance } = await WebAssembly.instantiate(bytes, {});
const native = Number(cargo("run"));
let wasm = 0;
for (let round = 0; round < 20; round++) {
  const start = performance.now();
  instance.exports.play(128);
  wasm = Math.max(wasm, (128 * 65.536) / (performance.now() - start));
}
console.log(
  `chaos game, fern: wasm ${wasm.toFixed(1)}, native ${native.toFixed(1)} million points a second: ${(wasm / native).toFixed(2)}`,
);
