/** The samples of the API pages: each runs in Node, of the very text that a page shows. */
import { execFileSync } from "node:child_process";
import {
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { afterAll, beforeAll, expect, it } from "vitest";
import { wrapped } from "../../www/build/api/wrapped";

const root = fileURLToPath(new URL("../..", import.meta.url));
const folder = join(root, "www/build/api/samples");
const names = readdirSync(folder).map((file) => file.replace(/\.js$/, ""));
const code = (name: string) => readFileSync(join(folder, `${name}.js`), "utf8");

interface Said {
  lines: string[];
  /** How many of a picture's bytes are not 0; null without one. */
  painted: number | null;
  problem?: string;
}
let scratch: string;
let said: Record<string, Said>;

/** What a page has, as far as a sample asks for it. */
const RUN = `
  globalThis.ImageData = class { constructor(pixels, width, height) { Object.assign(this, { pixels, width, height }); } };
  const said = {};
  for (const name of JSON.parse(process.argv[2])) {
    const lines = [];
    let painted = null;
    const put = ({ pixels, width, height }) => {
      if (pixels.length !== 4 * width * height) throw new Error("another size");
      painted = pixels.filter((byte) => byte !== 0).length;
    };
    const console = { log: (...words) => lines.push(words.map(String).join(" ")) };
    const document = { querySelector: () => ({ getContext: () => ({ putImageData: put }) }) };
    let problem;
    try {
      const { default: run } = await import("./" + name + ".js");
      await run(console, document);
    } catch (thrown) {
      problem = String(thrown.message ?? thrown);
    }
    said[name] = { lines, painted, problem };
  }
  process.stdout.write(JSON.stringify(said));`;

beforeAll(() => {
  scratch = mkdtempSync(join(tmpdir(), "frond-samples-"));
  mkdirSync(join(scratch, "node_modules"));
  symlinkSync(join(root, "www/pkg"), join(scratch, "node_modules/frond-ifs"));
  writeFileSync(join(scratch, "package.json"), '{ "type": "module" }');
  for (const name of names) writeFileSync(join(scratch, `${name}.js`), wrapped(code(name)));
  writeFileSync(join(scratch, "run.js"), RUN);
  const words = [join(scratch, "run.js"), JSON.stringify(names)];
  said = JSON.parse(execFileSync(process.execPath, words, { cwd: scratch }).toString());
});

afterAll(() => rmSync(scratch, { recursive: true, force: true }));

it.each(names)("%s runs, and does what it says", (name) => {
  const { lines, painted, problem } = said[name] as Said;
  expect(problem).toBeUndefined();
  expect(code(name)).toMatch(new RegExp(`import init, \\{[^}]*\\b${name}\\b`));
  if (code(name).includes("canvas")) expect(painted).toBeGreaterThan(1000);
  else expect(lines.join("\n")).toMatch(/\w/);
  const told = [...code(name).matchAll(/console\.log\(.*\); \/\/ (.*)$/gm)].map(([, result]) => result);
  for (const result of told) expect(lines).toContain(result);
});
