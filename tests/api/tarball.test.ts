/** The package as it is published: packed, installed elsewhere, and asked for each of its entries. */
import { execFileSync, spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { checkPackage, createPackageFromTarballData } from "@arethetypeswrong/core";
import { publint } from "publint";
import { formatMessage } from "publint/utils";
import { build } from "vite";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { crates, licenseText, scripts } from "../../www/build/licenses";

const root = fileURLToPath(new URL("../..", import.meta.url));
const scratch = mkdtempSync(join(tmpdir(), "frond-package-"));
const folder = join(scratch, "frond");
const app = join(scratch, "app");
let tarball: Buffer;
let manifest: { version: string; exports: Record<string, string | Record<string, string>> };

const node = (program: string) =>
  execFileSync(process.execPath, ["--input-type=module", "--eval", program], { cwd: app }).toString();

beforeAll(async () => {
  cpSync(join(root, "www/pkg"), folder, { recursive: true });
  // What is written by hand is taken from where it is written, the newest at all times.
  cpSync(join(root, "crate/xtask/src/package/entries"), folder, { recursive: true });
  const { version } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  const text = readFileSync(join(root, "crate/xtask/src/package/package.json"), "utf8");
  writeFileSync(join(folder, "package.json"), text.replace("0.0.0", version));
  await build({
    configFile: join(root, "www/build/package.config.ts"),
    logLevel: "silent",
    build: { outDir: folder, emptyOutDir: false },
  });
  // The element is built with the site, and tested there.
  if (!existsSync(join(folder, "frond-view.js"))) writeFileSync(join(folder, "frond-view.js"), "void 0;\n");
  for (const name of ["LICENSE-MIT", "LICENSE-APACHE"]) cpSync(join(root, name), join(folder, name));
  writeFileSync(join(folder, "licenses.txt"), licenseText([...crates(), ...scripts()]));
  const pack = ["pack", "--json", "--pack-destination", scratch];
  execFileSync("npm", pack, { cwd: folder, stdio: ["ignore", "ignore", "ignore"] });
  manifest = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  const file = join(scratch, `frond-${manifest.version}.tgz`);
  tarball = readFileSync(file);
  mkdirSync(app);
  writeFileSync(join(app, "package.json"), '{ "private": true }');
  const install = ["install", "--offline", "--no-audit", "--no-fund", file];
  execFileSync("npm", install, { cwd: app, stdio: ["ignore", "ignore", "ignore"] });
});

afterAll(() => rmSync(scratch, { recursive: true, force: true }));

describe("the packed package", () => {
  it("is as publint wants it", async () => {
    const { buffer, byteOffset, byteLength } = tarball;
    const packed = buffer.slice(byteOffset, byteOffset + byteLength) as ArrayBuffer;
    const { messages, pkg } = await publint({ pack: { tarball: packed }, strict: true });
    expect(messages.map((message) => formatMessage(message, pkg))).toEqual([]);
  });

  it("has the right types at each entry, for Node and for bundlers", async () => {
    const found = await checkPackage(createPackageFromTarballData(tarball), {
      excludeEntrypoints: Object.keys(manifest.exports).filter((entry) => entry.endsWith(".wasm")),
    });
    if (!found.types) throw new Error("There are no types.");
    // It is for those who know `import`: it has nothing for older ways.
    const wrong = found.problems.filter(
      (problem) => !("resolutionKind" in problem) || !/node10|node16-cjs/.test(problem.resolutionKind),
    );
    expect(wrong).toEqual([]);
  });

  it("brings its licences and a README, and none of its parts is missing", () => {
    const files = execFileSync("tar", ["-tzf", join(scratch, `frond-${manifest.version}.tgz`)]).toString();
    const named = Object.values(manifest.exports).flatMap((entry) =>
      typeof entry === "string" ? [entry] : Object.values(entry),
    );
    const wanted = [
      ...named.map((file) => file.slice(2)),
      "README.md",
      "LICENSE-MIT",
      "LICENSE-APACHE",
      "licenses.txt",
    ];
    const there = new Set(files.trim().split("\n"));
    expect(wanted.filter((file) => !there.has(`package/${file}`))).toEqual([]);
    // What others wrote is told in one place.
    const told = [...there].filter((file) => /licen[sc]e/i.test(file)).map((file) => file.slice(8));
    expect(told.sort()).toEqual(["LICENSE-APACHE", "LICENSE-MIT", "licenses.txt"]);
  });

  it("can be imported at each entry in Node, also where there is nothing to draw on", () => {
    const entries = Object.keys(manifest.exports).filter((entry) => !/\.(wasm|json)$|worker/.test(entry));
    const said = node(`
      for (const entry of ${JSON.stringify(entries)}) {
        const { default: init } = await import(entry.replace(".", "frond"));
        await init?.();
        console.log(entry);
      }
      const { createRenderer, createLocusCompute } = await import("frond/renderer");
      console.log(await createLocusCompute());
      await createRenderer({}).catch(({ code }) => console.log(code));`);
    expect(said.trim().split("\n")).toEqual([...entries, "undefined", "no-canvas"]);
  });

  it("is found by those who still say require", () => {
    const program = `
      const { createRequire } = await import("node:module");
      const { presets, default: init } = createRequire(${JSON.stringify(join(app, "app.cjs"))})("frond/draw");
      await init();
      console.log(presets().length > 10);`;
    expect(node(program).trim()).toBe("true");
  });

  it("computes in workers what it computes at once, and says how far it is", () => {
    const said = node(`
      import { createPool } from "frond/pool";
      import init, { connectedness, locus, planPath, presets } from "frond";
      import initFit, { fitCurve } from "frond/fit";
      await Promise.all([init(), initFit()]);
      const shape = (name) => presets().find(({ id }) => id === name);
      const [from, to] = [shape("dragon-3"), shape("gasket")];
      const pool = createPool({ size: 2 });
      const same = (p, q) => JSON.stringify(p) === JSON.stringify(q);
      const shares = [];
      const options = { width: 31, height: 31 };
      const whole = await pool.locus(from, to, options, { onProgress: (share) => shares.push(share) });
      const rising = shares.every((share, i) => share > (shares[i - 1] ?? 0));
      console.log(same(whole, locus(from, to, options)), shares.length > 8, rising, shares.at(-1));
      console.log(same(await pool.planPath(from, to), planPath(from, to)));
      console.log(same(await pool.connectedness(from), connectedness(from)));
      const round = Array.from({ length: 240 }, (_, i) => (i % 2 ? Math.sin : Math.cos)((i >> 1) / 19.1));
      const fit = { numbers: 24 };
      console.log(same(await pool.fitCurve(round, fit), fitCurve(round, fit)));
      console.log(await pool.connectedness({ maps: [] }).catch(({ code }) => code));`);
    expect(said.trim().split("\n")).toEqual(["true true true 1", "true", "true", "true", "no-maps"]);
  });

  it("leaves work in workers at once when it is called off, and ends with the program", () => {
    const said = node(`
      import { createPool } from "frond/pool";
      const pool = createPool({ size: 1 });
      const gasket = [[0.5, 0, 0, 0.5, 0, 0], [0.5, 0, 0, 0.5, 0.5, 0], [0.5, 0, 0, 0.5, 0.25, 0.433]];
      const turned = { maps: gasket.map(([a, , , d, e, f]) => [0, a, -d, 0, e, f]) };
      const calling = new AbortController();
      const size = { width: 400, height: 400 };
      const work = pool.locus({ maps: gasket }, turned, size, { signal: calling.signal, onProgress: () => calling.abort() });
      console.log(await work.catch(({ name }) => name));
      const gone = pool.connectedness({ maps: gasket }, undefined, { signal: AbortSignal.abort() });
      console.log(await gone.catch(({ name }) => name));
      const closed = pool.connectedness({ maps: gasket });
      pool.close();
      console.log(await closed.catch(({ code }) => code));
      console.log(await pool.routes(turned, turned).catch(({ code }) => code));
      console.log((await createPool().connectedness({ maps: gasket })).verdict.length > 0);`);
    expect(said.trim().split("\n")).toEqual(["AbortError", "AbortError", "stopped", "closed", "true"]);
  });

  // Older checkouts may lack the bundler; `cargo xtask test` installs it.
  it.skipIf(!existsSync(join(root, "node_modules/webpack")))("is bundled for Node, with its workers", () => {
    writeFileSync(
      join(app, "app.js"),
      `import init, { presets } from "frond/draw";
      import { createPool } from "frond/pool";
      await init();
      const pool = createPool({ size: 1 });
      const { verdict } = await pool.connectedness(presets().find(({ id }) => id === "fern"));
      pool.close();
      console.log(verdict);`,
    );
    execFileSync(process.execPath, [join(root, "tests/api/bundle.mjs"), "webpack-node", app]);
    // What it is bundled of is not needed any more.
    const out = join(scratch, "bundled");
    cpSync(join(app, "out/webpack-node"), out, { recursive: true });
    expect(execFileSync(process.execPath, [join(out, "main.js")]).toString()).toBe("touching\n");
  });

  it("has a command that draws, decides, exports and checks", () => {
    const frond = (...words: string[]) => {
      const command = join(app, "node_modules/.bin/frond");
      const { status, stdout, stderr } = spawnSync(command, words, { cwd: app, encoding: "utf8" });
      expect(`${stdout}${stderr}`).not.toMatch(/^ +at /m);
      return { status, stdout, stderr };
    };
    const bytes = (file: string) => readFileSync(join(app, file));
    const link = "a=dragon-3&b=gasket&path=straight";
    const size = ["--width", "60", "--height", "40"];
    expect(frond("--help").stdout).toContain("frond render <link>");
    expect(frond("render", link, "--out", "x.png", "--t", "0.5", ...size).status).toBe(0);
    expect([bytes("x.png").readUInt32BE(16), bytes("x.png").readUInt32BE(20)]).toEqual([60, 40]);
    // The picture holds its link, and so opens as maps.
    expect(JSON.parse(frond("export", "x.png", "--as", "json").stdout).maps ?? []).not.toEqual([]);
    for (const [file, starts] of [
      ["x.gif", "GIF89a"],
      ["x.zip", "PK"],
      ["x.apng", "\x89PNG"],
    ] as const) {
      const film = ["--seconds", "0.3", "--fps", "10", "--background", "#ffffff"];
      expect(frond("render", link, "--out", file, ...film, ...size)).toMatchObject({ status: 0 });
      expect(bytes(file).toString("latin1", 0, starts.length)).toBe(starts);
    }
    expect(frond("render", link, "--out", "x.mp4")).toMatchObject({
      status: 2,
      stderr: expect.stringMatching(/ffmpeg/),
    });
    expect(frond("locus", link, "--out", "x.csv", "--width", "7", "--height", "7").status).toBe(0);
    expect(bytes("x.csv").toString().trim().split("\n").length).toBeGreaterThanOrEqual(49);
    writeFileSync(join(app, "dust.json"), '{ "maps": [[0.3,0,0,0.3,0,0],[0.3,0,0,0.3,0.7,0]] }');
    const decided = frond("connectedness", "dust.json");
    expect([decided.status, JSON.parse(decided.stdout).verdict]).toEqual([1, "disconnected"]);
    writeFileSync(join(app, "bad.json"), "{}");
    expect(frond("check", "bad.json").status).toBeGreaterThan(0);
    expect(frond("render", "a=%%%", "--out", "y.png", "--width", "-3").status).toBe(2);
    expect(frond("render", "fern", "--out", "y.png").stderr).toMatch(/^frond: "fern" is no link/);
    expect(frond("connectedness", "none.ifs")).toMatchObject({
      status: 2,
      stderr: "frond: There is no none.ifs.\n",
    });
    expect(frond("dance").stderr).toBe('frond: There is no command "dance". See frond --help.\n');
  });
});
