/** The package as it is published: built, packed, and installed into a program of its own. */
import { execFileSync, spawnSync } from "node:child_process";
import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "vite";
import { expect } from "vitest";
import { crates, licenseText, scripts } from "../../www/build/licenses";
import { sbom } from "../../www/build/sbom";

export const root = fileURLToPath(new URL("../..", import.meta.url));

export interface Manifest {
  version: string;
  exports: Record<string, string | Record<string, string>>;
}

/** Milliseconds for it: a busy machine may take as long as it needs. */
export const PACKING_MS = 300_000;

export type Packed = Awaited<ReturnType<typeof packed>>;

/** `drop()` it. */
export async function packed() {
  const scratch = mkdtempSync(join(tmpdir(), "frond-package-"));
  const folder = join(scratch, "frond");
  const app = join(scratch, "app");
  cpSync(join(root, "www/pkg"), folder, { recursive: true });
  // What is written by hand is taken from where it is written, the newest at all times.
  cpSync(join(root, "crate/xtask/src/package/entries"), folder, { recursive: true });
  const { version } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  const text = readFileSync(join(root, "crate/xtask/src/package/package.json"), "utf8");
  writeFileSync(join(folder, "package.json"), text.replace("0.0.0", version));
  const entry = readFileSync(join(root, "crate/xtask/src/package/node-module.js"), "utf8");
  const others = readFileSync(join(root, "crate/xtask/src/package.rs"), "utf8");
  for (const [, name = "", module = ""] of others.matchAll(/^ {4}\("(\w+)", "(frond[\w-]*)"\),$/gm))
    writeFileSync(join(folder, `node/${name}.js`), entry.replaceAll("MODULE", module));
  // The page's own modules are none of the package's.
  for (const name of ["frond-first", "frond-bend"])
    for (const end of [".js", ".d.ts", "_bg.wasm", "_bg.wasm.d.ts"])
      rmSync(join(folder, name + end), { force: true });
  for (const config of ["package", "view"])
    await build({
      configFile: join(root, `www/build/${config}.config.ts`),
      logLevel: "silent",
      build: { outDir: folder, emptyOutDir: false },
    });
  // The script of the element is built with the site, and tested there.
  if (!existsSync(join(folder, "frond-view.js"))) writeFileSync(join(folder, "frond-view.js"), "void 0;\n");
  for (const name of ["LICENSE-MIT", "LICENSE-APACHE"]) cpSync(join(root, name), join(folder, name));
  writeFileSync(join(folder, "licenses.txt"), licenseText([...crates(), ...scripts()]));
  writeFileSync(join(folder, "sbom.cdx.json"), sbom());
  execFileSync(process.execPath, [join(root, "www/build/package/finish.mjs"), folder]);
  const pack = ["pack", "--json", "--pack-destination", scratch];
  execFileSync("npm", pack, { cwd: folder, stdio: ["ignore", "ignore", "ignore"] });
  const manifest: Manifest = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  const tarball = join(scratch, `frond-ifs-${manifest.version}.tgz`);
  mkdirSync(app);
  writeFileSync(join(app, "package.json"), '{ "private": true }');
  const install = ["install", "--offline", "--no-audit", "--no-fund", tarball];
  execFileSync("npm", install, { cwd: app, stdio: ["ignore", "ignore", "ignore"] });
  return {
    scratch,
    /** The folder of the package before it was packed. */
    folder,
    /** Where it is installed. */
    app,
    tarball,
    manifest,
    /** What a program prints that uses it. */
    node: (program: string) =>
      execFileSync(process.execPath, ["--input-type=module", "--eval", program], { cwd: app }).toString(),
    drop: () => rmSync(scratch, { recursive: true, force: true }),
  };
}

/** The command of an installed package, run in its folder; no answer of it is a trace of the program. */
export function commandIn(app: string) {
  const command = join(app, "node_modules/.bin/frond");
  const bytes = (file: string) => readFileSync(join(app, file));
  /** With these programs beside it, shell scripts by their names, and no others. */
  const beside = (programs: Record<string, string>) => {
    const folder = mkdtempSync(join(app, "programs-"));
    symlinkSync(process.execPath, join(folder, "node"));
    for (const [name, text] of Object.entries(programs))
      writeFileSync(join(folder, name), `#!/bin/sh\n${text}\n`, { mode: 0o755 });
    return { ...process.env, PATH: folder };
  };
  const run = (
    words: string[],
    { env = process.env, input }: { env?: NodeJS.ProcessEnv; input?: string | Buffer },
  ) => {
    const { status, stdout, stderr } = spawnSync(command, words, {
      cwd: app,
      env,
      maxBuffer: 1 << 28,
      ...(input === undefined ? {} : { input }),
    });
    const said = { status, stdout: stdout.toString(), stderr: stderr.toString() };
    expect(`${said.stdout}${said.stderr}`).not.toMatch(/^ +at /m);
    return { ...said, bytes: stdout };
  };
  return {
    command,
    bytes,
    beside,
    frond: (...words: string[]) => run(words, {}),
    /** With something on its standard input. */
    given: (input: string | Buffer, ...words: string[]) => run(words, { input }),
    frondBeside: (programs: Record<string, string>, ...words: string[]) =>
      run(words, { env: beside(programs) }),
    /** The width and height of a PNG. */
    sides: (file: string) => [bytes(file).readUInt32BE(16), bytes(file).readUInt32BE(20)],
  };
}
