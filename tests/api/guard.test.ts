/** What every function of the package does with what is wrong: it works, or throws a FrondError that says what is. */
import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { type Call, declarations } from "../../www/build/package/declarations";
import { ENTRIES } from "../../www/build/package/ship";
import { type Packed, packed, root } from "./packed";

let all: Packed;

beforeAll(async () => {
  all = await packed();
}, 240_000);

afterAll(() => all.drop());

const lines = (program: string) => all.node(program).trim().split("\n");

const COMMON = ["start", "initSync", "__wbg_init"];

/** All that can be called, as `nonsense.mjs` takes it. */
function signatures() {
  return ENTRIES.map(([entry, name]) => {
    const found = declarations(readFileSync(join(root, `www/pkg/${name}.d.ts`), "utf8"));
    const row = (label: string, { name, parameters }: Call, of?: string) => ({ label, name, parameters, of });
    const functions = [...new Map(found.functions.map((call) => [call.name, call])).values()]
      .filter(({ name }) => !COMMON.includes(name))
      .map((call) => row(call.name, call));
    const classes = found.classes.flatMap(({ name, calls }) =>
      calls.map((call) =>
        call.kind === "constructor"
          ? { ...row(`new ${name}`, call), name }
          : row(`${name}.${call.name}`, call, name),
      ),
    );
    return [entry, [...functions, ...classes]] as const;
  });
}

describe("nonsense", () => {
  it("is refused by every function in words, or does no harm", { timeout: 900_000 }, () => {
    const file = join(all.scratch, "signatures.json");
    const called = signatures();
    writeFileSync(file, JSON.stringify(called));
    const program = join(root, "tests/api/nonsense.mjs");
    const { stdout, stderr } = spawnSync(
      process.execPath,
      [program, join(all.app, "node_modules/frond-ifs"), file],
      { encoding: "utf8", maxBuffer: 1 << 28 },
    );
    const { problems, calls } = JSON.parse(stdout || `{ "problems": [${JSON.stringify(stderr)}] }`);
    expect(problems).toEqual([]);
    const functions = called.reduce((sum, [, rows]) => sum + rows.length, 0);
    expect(functions).toBeGreaterThan(180);
    expect(calls).toBeGreaterThan(100 * functions);
  });
});

describe("an error", () => {
  it("is a FrondError of whatever entry, with its code and with words that name the argument", () => {
    const said = lines(`
      import init, { attractor, connectedness, decodeScene, FrondError, LocusTiles, planPath, rasterize } from "frond-ifs";
      import initFit, { fitCurve, FrondError as Fit, HoughFirst } from "frond-ifs/fit";
      import initExchange, { importFile } from "frond-ifs/exchange";
      import initMorph, { LinkedMorph } from "frond-ifs/morph";
      import { createPool } from "frond-ifs/pool";
      await Promise.all([init(), initFit(), initExchange(), initMorph()]);
      const tell = (call) => {
        try {
          console.log("it works", call());
        } catch (problem) {
          const known = problem instanceof FrondError && problem instanceof Fit && problem instanceof Error;
          console.log(known ? problem.code + ": " + problem.message : "another error " + problem);
        }
      };
      const gasket = { maps: [[0.5, 0, 0, 0.5, 0, 0], [0.5, 0, 0, 0.5, 0.5, 0]] };
      // Those of the system have a code as well.
      tell(() => { throw Object.assign(new Error("no file"), { code: "ENOENT" }); });
      tell(() => attractor());
      tell(() => attractor({ maps: [[0.5, 0, 0, 0.5, 0, 0], [0.5, 0, 0, 0.5, 0, 0], [1, 2, 3, 4, 5, 6, 7]] }, { points: 5 }));
      tell(() => attractor(gasket, { points: "5" }));
      tell(() => attractor(gasket));
      tell(() => rasterize(gasket, { width: 10, height: 10, palette: ["red", 5] }));
      tell(() => planPath(gasket, gasket, { turns: [0, 1.5] }));
      tell(() => connectedness({ maps: [] }));
      tell(() => fitCurve([[0, 0], [1, 0], [1, 1]]));
      tell(() => fitCurve("0 0 1 0 1 1"));
      tell(() => importFile("a text"));
      tell(() => new LocusTiles(gasket, gasket, { width: 7, height: 7 }).patch({ x0: 0, y0: 0, x1: 2 }));
      tell(() => decodeScene(7));
      tell(() => new LinkedMorph("%%%&&=="));
      tell(() => LocusTiles(gasket));
      console.log(decodeScene("%%%&&==").problem.code, decodeScene("").problem, decodeScene("a=fern").problem);
      const pool = createPool({ size: 1 });
      for (const given of [{ maps: [] }, { maps: "x" }, { maps: () => 1 }])
        await pool.connectedness(given).catch((problem) => tell(() => { throw problem; }));
      pool.close();`);
    expect(said).toEqual([
      "another error Error: no file",
      "bad-input: attractor(): ifs must be an object with maps, and is not given.",
      "bad-input: attractor(): ifs.maps[2] must be a list of six numbers, and is a list of 7.",
      'bad-input: attractor(): options.points must be a number, and is the text "5".',
      "bad-input: attractor(): options must be an object with points, and is not given.",
      "bad-input: rasterize(): options.palette[1] must be a text, and is 5.",
      "bad-input: planPath(): options.turns[1] must be a whole number that is not too large, and is 1.5.",
      expect.stringMatching(/^no-maps: /),
      "bad-input: fitCurve(): outline[0] must be a number, and is a list of 2: it is one flat list.",
      'bad-input: fitCurve(): outline must be a Float64Array or a list of numbers, and is the text "0 0 1 0 1 1".',
      'bad-input: importFile(): bytes must be a Uint8Array or a list of numbers, and is the text "a text".',
      "bad-input: patch(): y1 must be a number, and is not given.",
      "bad-input: decodeScene(): text must be a text, and is 7.",
      expect.stringMatching(/^not-a-link: This is no link of Frond\. One looks like "a=fern&b=tree"/),
      "bad-input: LocusTiles is a class: it is made by new.",
      "not-a-link undefined undefined",
      expect.stringMatching(/^no-maps: /),
      'bad-input: connectedness(): ifs.maps must be a list, and is the text "x".',
      expect.stringMatching(/^bad-input: This cannot be sent to a worker: /),
    ]);
  });

  it("tells what is called before init(), and after free()", () => {
    const said = lines(`
      import init, { attractor, FrondError, LocusTiles, presets } from "frond-ifs";
      const tell = (call) => {
        try {
          console.log(call() ?? "nothing");
        } catch (problem) {
          console.log(problem instanceof FrondError && problem.code, problem.message);
        }
      };
      tell(() => presets());
      tell(() => new LocusTiles());
      await init({ frond: new Uint8Array(9) }).catch((problem) => tell(() => { throw problem; }));
      await init();
      const tiles = new LocusTiles(presets()[0], presets()[0], { width: 7, height: 7 });
      tiles.free();
      tell(() => tiles.run(0, 2, 1, true));
      tell(() => tiles.free());
      tell(() => tiles[Symbol.dispose]?.());
      tell(() => tiles instanceof LocusTiles && tiles.constructor === LocusTiles);`);
    expect(said).toEqual([
      "not-started Call init() of frond-ifs/draw, and wait for it, before presets().",
      "not-started Call init() of frond-ifs/proof, and wait for it, before new LocusTiles().",
      expect.stringMatching(/^not-loaded The module of frond-ifs\/draw could not be loaded: .*\.wasm file/),
      "freed run() was called after free(). Make another one by new.",
      "nothing",
      "nothing",
      "true",
    ]);
  });

  it("of a module that breaks is told as such, and the module begins anew", () => {
    const said = lines(`
      import init, { attractor, FrondError, presets, Sheet } from "frond-ifs/draw";
      const { memory } = await init();
      const [shape] = presets();
      const old = () => new Sheet(new Uint8Array(16), 2, 2);
      const [sheet, other] = [old(), old()];
      const tell = (call) => {
        try {
          console.log(call());
        } catch (problem) {
          console.log(problem instanceof FrondError && problem.code, problem.cause instanceof WebAssembly.RuntimeError);
        }
      };
      // Nothing in it is what it was.
      new Uint8Array(memory.buffer).fill(255);
      tell(() => attractor(shape, { points: 5 }));
      tell(() => attractor(shape, { points: 5 }).positions.length);
      tell(() => sheet.draw(null, 2, { width: 4, height: 4 }));
      // What was of the old one is not freed in the new one.
      other.free();
      other.free();
      tell(() => old().draw(null, 2, { width: 4, height: 4 }).length);
      tell(() => presets().length > 10);`);
    expect(said).toEqual(["broken true", "10", "broken false", "64", "true"]);
  });
});

describe("frond-ifs/lazy", () => {
  it("has every function of every entry, and what makes each object", () => {
    const functions = signatures().flatMap(([, rows]) => rows.filter(({ of }) => !of));
    const wanted = functions.map(({ label }) => label.replace("new ", "new"));
    const said = lines(`
      import * as lazy from "frond-ifs/lazy";
      for (const name of ${JSON.stringify(wanted)}) if (typeof lazy[name] !== "function") console.log(name);
      console.log("all");`);
    expect(said).toEqual(["all"]);
  });

  it("fetches a module when it is first called, and answers as it does", () => {
    const said = lines(`
      import { attractor, FrondError, newLinkedMorph, presets } from "frond-ifs/lazy";
      import init, * as draw from "frond-ifs/draw";
      try { draw.presets(); } catch ({ code }) { console.log(code); }
      const [shape] = await presets();
      console.log(JSON.stringify(shape) === JSON.stringify(draw.presets()[0]));
      await attractor().catch((problem) => console.log(problem instanceof FrondError, problem.message));
      const morph = await newLinkedMorph("a=fern&b=tree");
      console.log(morph.a, morph.draw({ u: 0, v: 0, width: 3, height: 3, x: 0, y: 0, scale: 1 }).length);`);
    expect(said).toEqual([
      "not-started",
      "true",
      "true attractor(): ifs must be an object with maps, and is not given.",
      expect.stringMatching(/^.+ 36$/),
    ]);
  });
});
