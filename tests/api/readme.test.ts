/** The code of README, docs and the package, and the types that the package brings: compiled strictly, and run. */
import { spawnSync } from "node:child_process";
import { mkdirSync, readdirSync, readFileSync, symlinkSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { type Packed, packed, root } from "./packed";

let all: Packed;

beforeAll(async () => {
  all = await packed();
  // Types of Node are there in most programs, and not in all: they are named where they are wanted.
  mkdirSync(join(all.app, "node_modules/@types"), { recursive: true });
  symlinkSync(join(root, "node_modules/@types/node"), join(all.app, "node_modules/@types/node"));
  symlinkSync(join(root, "node_modules/undici-types"), join(all.app, "node_modules/undici-types"));
}, 240_000);

afterAll(() => all.drop());

/** The code of a paper, in order: what is between its fences, or between the tags of its scripts. */
function blocks(file: string): string[] {
  const text = readFileSync(join(root, file), "utf8");
  const found = [...text.matchAll(/^```(js|html)\n([\s\S]*?)^```$/gm)];
  return found.flatMap(([, kind, code = ""]) => {
    if (kind === "js") return [code];
    return [...code.matchAll(/<script type="module">([\s\S]*?)<\/script>/g)].map(([, script = ""]) => script);
  });
}

/** Of the package; the others are about the element and the frame, in pages and frameworks around them. */
const ofPackage = (code: string) =>
  /frond-ifs|\.\/frond\//.test(code) && !/frond-ifs\/(?:view|jsx)/.test(code);

/** A page takes the file; whoever installs takes the entry. */
const installed = (code: string) =>
  code.replace(/"\.\/(?:node_modules\/frond-ifs|frond)\/frond\.js"/, '"frond-ifs/draw"');

/** Whatever has code for the package; that of `docs/embed.md` is run by `tests/hosts`. */
const PAPERS = [
  "README.md",
  ...readdirSync(join(root, "docs"))
    .filter((file) => file.endsWith(".md") && file !== "embed.md")
    .map((file) => `docs/${file}`),
  "crate/xtask/src/package/entries/README.md",
];

const SAMPLES = PAPERS.flatMap((file) =>
  blocks(file)
    .filter(ofPackage)
    .map((code, i) => ({
      name: `${file.replace(/\.md$/, "").replaceAll("/", "-")}-${i + 1}`,
      code: installed(code),
    })),
);

/** What the compiler has to say of these files. */
function compiled(files: Record<string, string>, options: Record<string, unknown>): string {
  const folder = join(all.app, "strict");
  mkdirSync(folder, { recursive: true });
  for (const [name, code] of Object.entries(files)) writeFileSync(join(folder, name), code);
  const compilerOptions = {
    strict: true,
    skipLibCheck: false,
    noEmit: true,
    target: "ES2022",
    lib: ["ES2022", "DOM", "DOM.Iterable"],
    types: [],
    ...options,
  };
  const config = { compilerOptions, files: Object.keys(files) };
  writeFileSync(join(folder, "tsconfig.json"), JSON.stringify(config));
  writeFileSync(join(folder, "package.json"), '{ "type": "module" }');
  const tsc = join(root, "node_modules/.bin/tsc");
  return spawnSync(tsc, ["-p", folder], { cwd: folder, encoding: "utf8" }).stdout;
}

const WAYS = {
  bundler: { module: "ESNext", moduleResolution: "bundler" },
  nodenext: { module: "NodeNext", moduleResolution: "nodenext" },
};

describe("README, docs and the package's README", () => {
  it("have code for the package", () => {
    expect(SAMPLES.length).toBeGreaterThanOrEqual(7);
  });

  it.each(Object.entries(WAYS))("have code that strict TypeScript compiles, with %s", (_, way) => {
    const files = Object.fromEntries(
      SAMPLES.map(({ name, code }) => [`${name}.ts`, `${code}\nexport {};\n`]),
    );
    expect(compiled(files, way)).toBe("");
  });

  it.each(SAMPLES.filter(({ code }) => !code.includes(".wasm")))("have code that runs: $name", ({ code }) => {
    // What a page has, as far as a picture asks for it.
    const page = `
      let put = 0;
      globalThis.ImageData = class { constructor(pixels, width, height) { if (pixels.length !== 4 * width * height) throw new Error("another size"); } };
      globalThis.document = { querySelector: () => ({ getContext: () => ({ putImageData: () => put++ }) }) };
      process.on("exit", () => console.log("pictures", put));`;
    // Imports come first, wherever they stand.
    const said = all.node(`${page}\n${code}`);
    expect(said).toMatch(code.includes("putImageData") ? /pictures 1/ : /\S\npictures 0/);
  });

  it("tell in comments what comes of it", () => {
    for (const { code } of SAMPLES) {
      const told = /^ *\/\/ (bad-input: .*)$/m.exec(code)?.[1];
      if (told) expect(all.node(code)).toBe(`${told}\n`);
    }
  });
});

describe("the types of the package", () => {
  const rest = `
    import init, { attractor, checkPath, connectedness, curvePresets, FrondError, interpolate, LocusTiles, rasterize } from "frond-ifs";
    import { presets } from "frond-ifs/draw";
    import { fitCurve, grownOutline, houghMaps, prepareOutline } from "frond-ifs/fit";
    import { outlineShape } from "frond-ifs/directed";
    import { LinkedMorph } from "frond-ifs/morph";
    import * as lazy from "frond-ifs/lazy";
    import { conjugate3 } from "frond-ifs/space";
    import wasm from "frond-ifs/frond_bg.wasm";

    await init();
    const rows: number[][] = [[0.5, 0, 0, 0.5, 0, 0], [0.5, 0, 0, 0.5, 0.5, 0]];
    const frozen = { maps: rows as readonly (readonly number[])[] } as const;
    const verdict: "connected" | "disconnected" | "touching" | "undecided" | "no-attractor" = connectedness(frozen).verdict;
    const between = interpolate(frozen, { maps: rows }, { u: 0.5, v: 0.5 });
    // What comes back is a row of six.
    const six: [number, number, number, number, number, number] | undefined = between.maps[0];
    const picture = new ImageData(rasterize({ maps: rows }, { width: 9, height: 9 }), 9, 9);
    checkPath(frozen, frozen, [[0, 0], [1, 1]]);
    checkPath(frozen, frozen, [[0, 0], [1, 1]], null);
    const tiles = new LocusTiles(frozen, frozen, { width: 7, height: 7 });
    const seen: Uint8Array = tiles.patch({ x0: 0, y0: 0, x1: 2, y1: 2 }).state;
    tiles.prove({ x0: 0, y0: 0, x1: 2, y1: 2 }, seen);
    tiles.patch(0, 0, 2, 2);
    tiles.free();
    const [curve] = curvePresets();
    outlineShape("one", curve.curve);
    const outline = grownOutline("oak");
    const crossings: number | null = prepareOutline(outline, 0.2).crossings;
    const knots: [number, number][] = fitCurve(outline, { numbers: 12 }).curve.knots;
    const widest: number = fitCurve(outline, { model: "collage" }).widest;
    const hits: number = houghMaps(outline, outline).found[0].hits;
    const linked = new LinkedMorph("a=fern&b=tree");
    const bytes: Uint8Array = linked.draw({ u: 0.5, v: 0.5, width: 9, height: 9, x: 0, y: 0, scale: 9 });
    linked.draw(0.5, 0.5, 0, 9, 9, 0, 0, 9, [0x112233]);
    const points: Promise<lazy.PointCloud> = lazy.attractor({ maps: rows }, { points: 5 });
    const later: Promise<lazy.LocusTiles> = lazy.newLocusTiles(frozen, frozen, { width: 7, height: 7 });
    conjugate3([[1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]], [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]);
    try {
      attractor(presets()[0], { points: 10 });
    } catch (problem) {
      if (problem instanceof FrondError) console.log(problem.code, problem.message, problem.cause);
    }
    console.log(verdict, six, picture.width, crossings, knots, widest, hits, bytes, points, later, wasm.length);`;

  it.each(Object.entries(WAYS))("are strict and take what is sensible, with %s", (_, way) => {
    expect(compiled({ "rest.ts": rest }, way)).toBe("");
    // Newer libraries have what disposes themselves, and Node's types declare it as well.
    expect(compiled({ "rest.ts": rest }, { ...way, lib: ["ES2022", "ESNext.Disposable", "DOM"] })).toBe("");
    expect(compiled({ "rest.ts": rest }, { ...way, lib: ["ESNext", "DOM"], types: ["node"] })).toBe("");
  });

  it.each([
    ["attractor({ maps: [[1, 2, '3']] }, { points: 5 });", "string"],
    ["attractor({ maps: [] }, { point: 5 });", "point"],
    ["const text: string = fitCurve([0, 0, 1, 0, 1, 1]);", "MeasuredCurve"],
    ["init().then((out) => out.nonsense);", "nonsense"],
  ])("refuse %s", (line, about) => {
    const code = `import init, { attractor } from "frond-ifs/draw";\nimport { fitCurve } from "frond-ifs/fit";\nvoid [init, attractor, fitCurve];\n${line}\n`;
    expect(compiled({ "refused.ts": code }, WAYS.bundler)).toContain(about);
  });

  it("say any nowhere", () => {
    const folder = join(all.app, "node_modules/frond-ifs");
    const files = readdirSync(folder).filter((file) => file.endsWith(".d.ts"));
    expect(files.length).toBeGreaterThan(15);
    const said = files.filter((file) => {
      const code = readFileSync(join(folder, file), "utf8").replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, "");
      return /\bany\b/.test(code);
    });
    expect(said).toEqual([]);
  });
});
