// The chaos game beside that of the crate `barnsley`, natively, one thread each, in one run.
import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../..", import.meta.url));
const options = {
  cwd: root,
  env: { ...process.env, CARGO_TARGET_DIR: `${root}target/peer` },
  encoding: "utf8",
};
const manifest = ["--manifest-path", "tests/bench/peer/Cargo.toml"];
console.log(execFileSync("cargo", ["run", "--quiet", "--release", ...manifest], options).trim());
