/** The package as it is published: packed, installed elsewhere, and asked for each of its entries. */
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
  const file = join(scratch, `frond-ifs-${manifest.version}.tgz`);
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
    const files = execFileSync("tar", [
      "-tzf",
      join(scratch, `frond-ifs-${manifest.version}.tgz`),
    ]).toString();
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
        const { default: init } = await import(entry.replace(".", "frond-ifs"));
        await init?.();
        console.log(entry);
      }
      const { createRenderer, createLocusCompute } = await import("frond-ifs/renderer");
      console.log(await createLocusCompute());
      await createRenderer({}).catch(({ code }) => console.log(code));`);
    expect(said.trim().split("\n")).toEqual([...entries, "undefined", "no-canvas"]);
  });

  it("is found by those who still say require", () => {
    const program = `
      const { createRequire } = await import("node:module");
      const { presets, default: init } = createRequire(${JSON.stringify(join(app, "app.cjs"))})("frond-ifs/draw");
      await init();
      console.log(presets().length > 10);`;
    expect(node(program).trim()).toBe("true");
  });

  it("computes in workers what it computes at once, and says how far it is", () => {
    const said = node(`
      import { createPool } from "frond-ifs/pool";
      import init, { connectedness, locus, planPath, presets } from "frond-ifs";
      import initFit, { fitCurve } from "frond-ifs/fit";
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
      import { createPool } from "frond-ifs/pool";
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
      `import init, { presets } from "frond-ifs/draw";
      import { createPool } from "frond-ifs/pool";
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

  /** The command, in its own folder; no answer of it is a trace of the program. */
  const frond = (...words: string[]) => frondBeside(null, ...words);
  /** With these programs beside it, shell scripts by their names, and no others. */
  const frondBeside = (programs: Record<string, string> | null, ...words: string[]) => {
    const command = join(app, "node_modules/.bin/frond");
    let env = process.env;
    if (programs) {
      const folder = mkdtempSync(join(app, "programs-"));
      symlinkSync(process.execPath, join(folder, "node"));
      for (const [name, text] of Object.entries(programs))
        writeFileSync(join(folder, name), `#!/bin/sh\n${text}\n`, { mode: 0o755 });
      env = { ...env, PATH: folder };
    }
    const { status, stdout, stderr } = spawnSync(command, words, { cwd: app, encoding: "utf8", env });
    expect(`${stdout}${stderr}`).not.toMatch(/^ +at /m);
    return { status, stdout, stderr };
  };
  const bytes = (file: string) => readFileSync(join(app, file));
  const sides = (file: string) => [bytes(file).readUInt32BE(16), bytes(file).readUInt32BE(20)];
  const link = "a=dragon-3&b=gasket&path=straight";
  const size = ["--width", "60", "--height", "40"];

  it("has a command that draws morphs as pictures, films and frames", () => {
    expect(frond("render", link, "--out", "x.png", "--t", "0.5", ...size).status).toBe(0);
    expect(sides("x.png")).toEqual([60, 40]);
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
    expect(frond("render", link, "--out", "n.png", "--frames", "3", ...size).status).toBe(0);
    expect(
      ["n-0001.png", "n-0002.png", "n-0003.png", "n-0004.png", "n.png"].map((file) =>
        existsSync(join(app, file)),
      ),
    ).toEqual([true, true, true, false, false]);
    expect(sides("n-0003.png")).toEqual([60, 40]);
    expect(bytes("n-0001.png").equals(bytes("n-0002.png"))).toBe(false);
    // Two frames more stand still at each end; the one in the middle is the same, however it goes.
    const paced = ["--frames", "3", "--fps", "10", "--hold", "0.2", "--ease", "in-out"];
    expect(frond("render", link, "--out", "p.png", ...paced, ...size).stderr).toContain("7 frames");
    const like = [1, 1, 1, 2, 3, 3, 3].map((frame) => bytes(`n-000${frame}.png`));
    like.forEach((frame, i) => {
      expect(bytes(`p-000${i + 1}.png`).equals(frame)).toBe(true);
    });
    const drawing = frond("render", link, "--out", "x.svg", "--t", "1");
    expect(drawing).toMatchObject({
      status: 0,
      stderr: expect.stringMatching(/^x\.svg: \d+ pieces of one size in 3 paths/),
    });
    expect(bytes("x.svg").toString().match(/<path/g)).toHaveLength(3);
  });

  it("draws bends and space as well", () => {
    const bent = "a=gasket&b=gasket&path=straight&tool=deform&mesh=4x4:0,0,1,1&keys=0:;0.5:6,0.2,0";
    expect(frond("render", bent, "--out", "bent.png", "--frames", "2", ...size).status).toBe(0);
    // The second key is half way round.
    expect(bytes("bent-0001.png").equals(bytes("bent-0002.png"))).toBe(false);
    expect(frond("render", bent, "--out", "bent.png", "--t", "0.5", ...size).status).toBe(0);
    expect(sides("bent.png")).toEqual([60, 40]);
    expect(frond("render", bent, "--out", "bent.svg").stderr).toMatch(/nothing bends/);
    const states = "directed-a=frond&directed-b=snowflake&mode=linear";
    expect(frond("render", states, "--out", "s.png", "--frames", "2", ...size)).toMatchObject({ status: 0 });
    expect(bytes("s-0001.png").equals(bytes("s-0002.png"))).toBe(false);
    const made = node(`
      import init, { defaultSpace, defaultView, packSpace } from "frond-ifs/space";
      await init();
      const space = defaultSpace();
      const view = defaultView(space);
      const keys = [0, 2].map((at) => ({ at, ease: "even", view: { ...view, turn: view.turn + at } }));
      const packed = packSpace({ ...space, timeline: { seconds: 2, loop: "once", course: "straight", keys } });
      console.log("tool=space&space=" + packed);`).trim();
    expect(frond("render", made, "--out", "space.png", "--frames", "2", ...size)).toMatchObject({
      status: 0,
    });
    expect(bytes("space-0001.png").equals(bytes("space-0002.png"))).toBe(false);
    const still = frond("render", "tool=space", "--out", "still.gif", ...size);
    expect(still).toMatchObject({
      status: 2,
      stderr: expect.stringMatching(/nothing to film: .*stands still/),
    });
    expect(frond("render", "tool=space", "--out", "still.png", ...size).status).toBe(0);
    expect(frond("connectedness", "tool=space").stderr).toMatch(/only draws pictures/);
    expect(frond("render", "tool=fit", "--out", "fit.png").stderr).toMatch(/no closed curves/);
  });

  it("decides, exports and checks", () => {
    expect(frond("locus", link, "--out", "x.csv", "--width", "7", "--height", "7").status).toBe(0);
    const samples = bytes("x.csv")
      .toString()
      .trim()
      .split("\n")
      .slice(1)
      .map((row) => row.split(",").map(Number));
    const place = (i: number) => samples[i]?.slice(0, 2);
    expect(samples.length).toBe(49);
    expect([place(0), place(1), place(7), place(48)]).toEqual([
      [-1, -1],
      [-0.5, -1],
      [-1, -0.5],
      [2, 2],
    ]);
    writeFileSync(join(app, "dust.json"), '{ "maps": [[0.3,0,0,0.3,0,0],[0.3,0,0,0.3,0.7,0]] }');
    const decided = frond("connectedness", "dust.json");
    expect([decided.status, JSON.parse(decided.stdout).verdict]).toEqual([1, "disconnected"]);
    node(`
      import init, { certificate } from "frond-ifs/proof";
      import { writeFileSync } from "node:fs";
      await init();
      const proof = certificate({ maps: [[0.3,0,0,0.3,0,0],[0.3,0,0,0.3,0.7,0]] });
      writeFileSync("proof.json", JSON.stringify(proof));`);
    expect(frond("check", "proof.json").status).toBe(0);
    writeFileSync(join(app, "bad.json"), "{}");
    expect(frond("check", "bad.json").status).toBeGreaterThan(0);
  });

  it("says of all that it cannot do what to do, before the work", () => {
    const help = frond("--help");
    expect([help.status, help.stdout]).toEqual([0, expect.stringContaining("frond render <link>")]);
    expect(frond("locus", "--help").stdout).toBe(help.stdout);
    expect(frond()).toMatchObject({ status: 2, stdout: "", stderr: help.stdout });
    const draw = (...words: string[]) => ["render", link, ...words];
    const cases: [words: string[], said: RegExp | string][] = [
      [["dance"], 'There is no command "dance". See frond --help.'],
      [["render"], '"frond render" of what? See frond --help.'],
      [["render", "a", "b", "--out", "x.png"], '"b" is one word too many. Put a link into quotes.'],
      [draw(), "Where to? Say --out and the name of a file."],
      [draw("--out"), "--out needs a value after it. See frond --help."],
      [draw("--out", "none/x.png"), "There is no folder none: make it first."],
      [draw("--out", "."), ". is a folder: name a file in it."],
      [draw("--out", "x.bmp"), /is to end with \.png, \.svg/],
      [draw("--out", "y.png", "--size", "3"), "There is no option --size. See frond --help."],
      [["check", "x", "--width", "3"], '"frond check" has no option --width. See frond --help.'],
      [draw("--out", "y.png", "--width", "-3"), "--width needs a value after it. See frond --help."],
      [draw("--out", "y.png", "--width", "1e9"), '--width is a number from 1 to 8192, and not "1e9".'],
      [draw("--out", "y.png", "--height", "NaN"), '--height is a number from 1 to 8192, and not "NaN".'],
      [draw("--out", "y.png", "--width", "9.5"), /whole number/],
      [draw("--out", "y.png", "--t", "2"), '--t is a number from 0 to 1, and not "2".'],
      [draw("--out", "y.png", "--background", "red"), "--background is a colour such as #ffffff."],
      [draw("--out", "y.gif", "--frames", "1e7"), /--frames is a number from 1 to 10000/],
      [draw("--out", "y.gif", "--frames", "2", "--seconds", "1"), /not both/],
      [draw("--out", "y.gif", "--hold", "11"), '--hold is a number from 0 to 10, and not "11".'],
      [draw("--out", "y.gif", "--ease", "fast"), '--ease is linear or in-out, and not "fast".'],
      [draw("--out", "y.png", "--hold", "1"), /^One picture has no --hold/],
      [
        [
          "render",
          "a=gasket&b=gasket&tool=deform&mesh=4x4:0,0,1,1&keys=0:;0.5:6,0.2,0",
          "--out",
          "y.gif",
          "--hold",
          "1",
        ],
        "This film has no --hold: its end goes on to its beginning.",
      ],
      [
        draw("--out", "y.gif", "--frames", "9999", "--width", "8192", "--height", "8192"),
        /too large for one file/,
      ],
      [["render", "fern", "--out", "y.png"], '"fern" is no link. One looks like "a=fern&b=tree".'],
      [["render", "a=%%%", "--out", "y.png"], /^The link cannot be read/],
      [["render", "a=gasket&tool=deform", "--out", "y.gif"], /nothing to film/],
      [["locus", link, "--out", "x.txt"], /is to end with \.csv or \.npy/],
      [["locus", link, "--out", "x.csv", "--width", "1"], '--width is a number from 2 to 4096, and not "1".'],
      [["connectedness", "none.ifs"], "There is no none.ifs."],
      [["connectedness", "/dev/zero"], /larger than 64 MB/],
      [["connectedness", link, "--epsilon", "no"], /--epsilon is a number/],
      [["check", "index.md"], "There is no index.md."],
      [["export", link, "--as", "word"], /^--as is one of json, /],
    ];
    for (const [words, said] of cases) {
      const { status, stdout, stderr } = frond(...words);
      expect([status, stdout], words.join(" ")).toEqual([2, ""]);
      const problem = stderr.replace(/^frond: /, "").trim();
      if (typeof said === "string") expect(problem).toBe(said);
      else expect(problem, words.join(" ")).toMatch(said);
    }
  });

  it("hands ffmpeg the frames of a video, where there is one", () => {
    const film = ["render", link, "--out", "x.mp4", "--frames", "3", ...size];
    // It writes what it was told, and how many bytes it was handed.
    const ffmpeg = `[ "$1" = -version ] && exit
      for last; do :; done
      bytes=$(/usr/bin/wc -c)
      echo "$bytes $*" > "\${last#file:}"`;
    expect(frondBeside({ ffmpeg }, ...film)).toMatchObject({ status: 0, stdout: "" });
    const said = bytes("x.mp4").toString();
    expect(Number.parseInt(said, 10)).toBe(3 * 60 * 40 * 4);
    expect(said).toContain("-f rawvideo -pix_fmt rgba -s 60x40 -r 25 -i -");
    expect(said).toMatch(/out_color_matrix=bt709.*:colorspace=bt709.* -pix_fmt yuv420p /);
    const full = '[ "$1" = -version ] && exit; echo "x.mp4: No space left on device" >&2; exit 1';
    const failed = frondBeside({ ffmpeg: full }, ...film);
    expect(failed.status).toBe(2);
    expect(failed.stderr).toContain("ffmpeg could not make x.mp4: x.mp4: No space left on device");
  });

  it("tells how a video is made, in words that a shell reads as they are meant", () => {
    const film = ["render", "a=fern&b='$(id)'", "--out", "my film.mp4", "--seconds", "2"];
    const { status, stderr } = frondBeside({}, ...film);
    expect(status).toBe(2);
    const [, draws = "", encodes = ""] = stderr.split("\n");
    const words = (line: string) =>
      execFileSync("sh", ["-c", `set -- ${line}; printf '%s\\n' "$@"`])
        .toString()
        .trim()
        .split("\n");
    expect(words(draws)).toEqual([
      "frond",
      "render",
      "a=fern&b='$(id)'",
      "--out",
      "my film.png",
      "--frames",
      "50",
      "--background",
      "#ffffff",
    ]);
    expect(words(encodes)).toEqual([
      "ffmpeg",
      "-framerate",
      "25",
      "-i",
      "my film-%04d.png",
      "-pix_fmt",
      "yuv420p",
      "my film.mp4",
    ]);
  });
});
