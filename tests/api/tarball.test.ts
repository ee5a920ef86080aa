/** The package as it is published: packed, installed elsewhere, and asked for each of its entries. */
import { execFileSync, spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import { cpSync, existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { checkPackage, createPackageFromTarballData } from "@arethetypeswrong/core";
import { publint } from "publint";
import { formatMessage } from "publint/utils";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { type Manifest, PACKING_MS, type Packed, packed, root } from "./packed";

let made: Packed;
let tarball: Buffer;
let manifest: Manifest;
let app: string;
let scratch: string;
let node: Packed["node"];

beforeAll(async () => {
  made = await packed();
  ({ manifest, app, scratch, node } = made);
  tarball = readFileSync(made.tarball);
}, PACKING_MS);

afterAll(() => made.drop());

describe("the packed package", () => {
  it("is as publint wants it", async () => {
    const { buffer, byteOffset, byteLength } = tarball;
    const data = buffer.slice(byteOffset, byteOffset + byteLength) as ArrayBuffer;
    const { messages, pkg } = await publint({ pack: { tarball: data }, strict: true });
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
    const files = execFileSync("tar", ["-tzf", made.tarball]).toString();
    const named = Object.values(manifest.exports).flatMap((entry) =>
      typeof entry === "string" ? [entry] : Object.values(entry),
    );
    const wanted = [
      ...named.map((file) => file.slice(2)),
      "README.md",
      "CHANGELOG.md",
      "custom-elements.json",
      "integrity.json",
      "examples/Morph.tsx",
      "examples/notebook.py",
      "examples/page.html",
      "examples/terminal.mjs",
      "LICENSE-MIT",
      "LICENSE-APACHE",
      "licenses.txt",
      "sbom.cdx.json",
    ];
    const there = new Set(files.trim().split("\n"));
    expect(wanted.filter((file) => !there.has(`package/${file}`))).toEqual([]);
    // What others wrote is told in one place.
    const told = [...there].filter((file) => /licen[sc]e/i.test(file)).map((file) => file.slice(8));
    expect(told.sort()).toEqual(["LICENSE-APACHE", "LICENSE-MIT", "licenses.txt"]);
  });

  it("has what follows from its files: sizes and hashes in its README and examples", () => {
    const of = (file: string) => readFileSync(join(app, "node_modules/frond-ifs", file));
    const hash = (file: string) => `sha384-${createHash("sha384").update(of(file)).digest("base64")}`;
    const readme = of("README.md").toString();
    for (const file of ["README.md", "examples/notebook.py"]) expect(of(file).toString()).not.toContain("{{");
    const size = gzipSync(of("frond-fit_bg.wasm"), { level: 9 }).length;
    expect(readme).toMatch(new RegExp(`\\| .frond-ifs/fit. \\|[^|]*\\| ${Math.round(size / 1e3)} kB \\|`));
    expect(readme).toContain(`integrity="${hash("frond-view.js")}"`);
    expect(of("examples/notebook.py").toString()).toContain(hash("frond-view.js"));
    const integrity = JSON.parse(of("integrity.json").toString());
    expect(integrity["./frond.js"]).toBe(hash("frond.js"));
    expect(integrity["./renderer.js"]).toBe(hash("renderer.js"));
    // The map names each script that the entry imports at once.
    const [, map = ""] = /<script type="importmap">([^<]*)</.exec(readme) ?? [];
    const { imports, integrity: checked } = JSON.parse(map);
    expect(checked[imports["frond-ifs/draw"]]).toBe(hash("frond.js"));
    const next = [
      ...of("frond.js")
        .toString()
        .matchAll(/from ['"]\.\/([^'"]+)/g),
    ];
    for (const [, file = ""] of next)
      expect(checked[new URL(file, imports["frond-ifs/draw"]).href]).toBe(hash(file));
  });

  it("has examples that run", () => {
    const examples = join(app, "node_modules/frond-ifs/examples");
    const run = (...words: string[]) =>
      spawnSync(process.execPath, [join(examples, "terminal.mjs"), ...words], { encoding: "utf8" });
    const { stdout } = run("gasket");
    expect(stdout).toMatch(/█.*\n/);
    expect(stdout).toMatch(/: (?:touching|connected)\n$/);
    expect(run("nothing")).toMatchObject({ status: 2, stderr: expect.stringContaining("gasket") });
    const page = readFileSync(join(examples, "page.html"), "utf8");
    const scripts = [...page.matchAll(/ src="([^"]+)"/g)].map(([, script = ""]) => join(examples, script));
    expect(scripts.map((script) => existsSync(script))).toEqual([true]);
    // All that the component imports is an entry, or React.
    const component = readFileSync(join(examples, "Morph.tsx"), "utf8");
    const asked = [...component.matchAll(/(?:from|import) "([^"]+)"/g)].map(([, name = ""]) => name);
    expect(asked.filter((name) => !manifest.exports[name.replace("frond-ifs", ".")])).toEqual(["react"]);
  });

  it("can be imported at each entry in Node, also where there is nothing to draw on", () => {
    const entries = Object.keys(manifest.exports).filter((entry) => !/\.(wasm|json)$|worker/.test(entry));
    const said = node(`
      for (const entry of ${JSON.stringify(entries)}) {
        const { default: init, ...rest } = await import(entry.replace(".", "frond-ifs"));
        await init?.();
        if (init) rest.start();
        console.log(entry, Boolean(init) === "initSync" in rest);
      }
      const { createRenderer, createLocusCompute } = await import("frond-ifs/renderer");
      console.log(await createLocusCompute());
      await createRenderer({}).catch(({ code }) => console.log(code));`);
    expect(said.trim().split("\n")).toEqual([
      ...entries.map((entry) => `${entry} true`),
      "undefined",
      "no-canvas",
    ]);
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
});
