import { readFileSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { afterEach, beforeAll, beforeEach, describe, expect, it } from "vitest";
import init, * as frond from "../../www/pkg/index.js";
import { type Codec, Link, route } from "../../www/src/document/link";
import { dismiss, notices } from "../../www/src/document/notice";
import { canUndo, scene } from "../../www/src/document/scene";

const read = (name: string) => readFile(new URL(`../../www/pkg/${name}`, import.meta.url));

/** Links that were given out, one a line: the same that the codec's own tests read. */
const GIVEN = readFileSync(new URL("../../crate/scene/tests/links.txt", import.meta.url), "utf8")
  .split("\n")
  .filter((line) => line !== "" && !line.startsWith("//"));

const zeros = (count: number) => `a=maps:${Array(count).fill("0.1,0,0,0.1,0,0").join(";")}`;

/** Damaged, huge and malicious fragments. Each opens what Frond begins with, and says so. */
const HOSTILE: Record<string, string> = {
  "nobody's shape": "a=nobody",
  "no maps": "a=maps:",
  "too few numbers": "a=maps:1,2,3",
  "not a number": "a=maps:NaN,0,0,0,0,0",
  infinite: "a=maps:1e999,0,0,0,0,0",
  "beyond squaring": "a=maps:1e200,0,0,0,0,0",
  "no attractor": "b=maps:0.5,0,0,0.5,0,0;2,0,0,2,0,0",
  "nearly no attractor": "a=maps:1,0,0,1,0,0",
  "65 maps": zeros(65),
  "65 waypoints": `path=drawn:${Array(65).fill("0,0").join(";")}`,
  "far away": "path=drawn:1e300,0",
  "no time": "t=NaN",
  "an impossible match": "match=1,1,2",
  "a huge match": "match=99999999999999999999",
  "too many turns": "turns=1,2,99",
  "no view": "view=0,0,0",
  "a tag": "colour=<script>window.hacked=1</script>",
  "half a percent sign": "a=%E0%A4%A&b=%",
  "a prototype": "a=__proto__&b=constructor",
  "version 0": "v=0",
  "70 kB": `a=${"maps:".repeat(14_000)}`,
  "a million maps": `a=maps:${";".repeat(1_000_000)}`,
};

let text = "";
let link: Link;
const said = () => notices.peek().map((notice) => notice.text);

beforeAll(() =>
  init({
    frond: read("frond_bg.wasm"),
    curve: read("frond-curve_bg.wasm"),
    proof: read("frond-proof_bg.wasm"),
  }),
);

beforeEach(() => {
  text = "";
  link = new Link(frond as unknown as Codec, {
    read: () => text,
    write: (fragment) => {
      text = fragment;
    },
  });
});

afterEach(() => {
  for (const { id } of notices.peek()) dismiss(id);
});

/** Without the check word, which old links have not. */
const bare = (written: string | null) => written?.replace(/&check=[^&]*/, "");

describe("a link that was given out", () => {
  it.each(GIVEN)("opens, and is written as it was: %s", (given) => {
    text = given;
    link.open();
    expect(route.peek()).toEqual({ page: "studio" });
    expect(said()).toEqual([]);
    expect(bare(link.fragment())).toBe(given);
    expect(link.flush()).toBe(true);
    expect(text).toBe(given);
  });

  it("is followed by the next, each a step of undo", () => {
    link.open();
    for (const given of GIVEN) {
      text = given;
      link.follow();
      expect(bare(link.fragment())).toBe(given);
    }
    expect(said()).toEqual([]);
    expect(canUndo.peek()).toBe(true);
  });
});

describe("a hostile link", () => {
  it.each(Object.keys(HOSTILE))("opens what Frond begins with, and says why: %s", (what) => {
    text = HOSTILE[what] ?? "";
    link.open();
    expect(scene.peek()).toEqual(frond.defaultScene());
    expect(said()).toEqual([expect.stringContaining("Frond shows its default shapes instead.")]);
  });

  it("does not take the place of a document without a word, either", () => {
    text = "v=1&a=koch&b=gasket";
    link.open();
    text = HOSTILE["a tag"] ?? "";
    link.follow();
    expect(scene.peek()).toMatchObject({ a: { preset: "dragon-3" }, b: { preset: "gasket" } });
    expect(said()).toEqual([expect.stringContaining("Frond shows its default shapes instead.")]);
  });
});

describe("a link of a later version", () => {
  it("shows what is understood", () => {
    text = "v=2&a=koch&b=gasket&weather=rain";
    link.open();
    expect(scene.peek().a.preset).toBe("koch");
    expect(said()).toEqual([expect.stringMatching(/a later version of Frond\..*to update it\.$/)]);
  });
});
