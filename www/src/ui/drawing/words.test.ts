import { expect, it } from "vitest";
import { alignOf, linesOf, type Run, textsOf } from "./words";

const run = (text: string, x: number, width: number, other: Partial<Run> = {}): Run => ({
  text,
  x,
  y: 20,
  width,
  look: { fill: "#111111" },
  size: 10,
  align: "start",
  ...other,
});
/** What is read in a file: parts of a text bring no space of their own. */
const read = (texts: readonly string[]) => texts.map((text) => text.replace(/<[^>]*>/g, ""));

it("keeps the space between words that look different, and makes none within a word", () => {
  const texts = textsOf([
    run("The number is ", 0, 66),
    run("0.849", 66, 30, { look: { fill: "#111111", "font-weight": "650" } }),
    run(". Row of w", 96, 50),
    run("2", 146, 5, { y: 23, size: 7 }),
  ]);
  expect(read(texts)).toEqual(["The number is 0.849. Row of w2"]);
  expect(texts[0]).toContain('xml:space="preserve"');
  // Only the first word is tied to a place: fonts differ in how wide they are.
  expect(texts[0]?.match(/ x="/g)).toHaveLength(1);
  expect(texts[0]).toContain('<tspan dy="3">2</tspan>');
});

it("puts a space where the page shows a gap, and leaves columns apart", () => {
  expect(read(textsOf([run("In pieces", 0, 50), run("gap 7%", 56, 30)]))).toEqual(["In pieces gap 7%"]);
  expect(read(textsOf([run("u 0.50", 0, 40), run("v 0.50", 52, 40)]))).toEqual(["u 0.50", "v 0.50"]);
  expect(read(textsOf([run("one", 0, 20), run("two", 0, 20, { y: 40 })]))).toEqual(["one", "two"]);
});

it("writes blanks and hostile words as words", () => {
  expect(textsOf([run(" \n", 0, 4), run(" a<b", 4, 20), run(" ", 24, 4)])).toEqual([
    '<text x="4" y="20" fill="#111111" xml:space="preserve">a&lt;b</text>',
  ]);
});

it("keeps the edge that words are set to", () => {
  const at = (align: Run["align"]) => textsOf([run("12", 10, 20, { align })])[0] ?? "";
  expect(at("start")).toContain('x="10"');
  expect(at("middle")).toContain('x="20" y="20" text-anchor="middle"');
  expect(at("end")).toContain('x="30" y="20" text-anchor="end"');
  expect(["left", "start", "center", "-webkit-center", "right", "end"].map(alignOf)).toEqual([
    "start",
    "start",
    "middle",
    "middle",
    "end",
    "end",
  ]);
});

it("breaks lines where the page did, without the space that was left out there", () => {
  const glyphs = [..."ab cd"].map((text, i) => ({ text, left: 5 * i, top: 0, width: 5 }));
  const broken = glyphs.map((glyph, i) =>
    i < 2 ? glyph : i === 2 ? { ...glyph, width: 0 } : { ...glyph, left: 5 * (i - 3), top: 12 },
  );
  expect(linesOf(glyphs).map(({ text }) => text)).toEqual(["ab cd"]);
  expect(linesOf(broken)).toEqual([
    { text: "ab", left: 0, top: 0, width: 10 },
    { text: "cd", left: 0, top: 12, width: 10 },
  ]);
});
