import { expect, test } from "vitest";
import { pasted } from "./pasted";

const FRAGMENT = "v=1&a=gasket&b=koch";

test.each([
  [`https://frond.example/studio/#${FRAGMENT}`, FRAGMENT],
  [`<https://frond.example/#${FRAGMENT}>`, `${FRAGMENT}>`],
  [`Look at this: file:///home/me/frond.html#${FRAGMENT} `, FRAGMENT],
  [`\n#${FRAGMENT}\n`, FRAGMENT],
  [FRAGMENT, FRAGMENT],
  ["http://localhost:5173/#v%3D1%26a%3Dgasket", "v%3D1%26a%3Dgasket"],
])("a link is one wherever it comes from: %s", (text, link) => {
  expect(pasted(text)).toEqual({ link });
});

test.each([
  ["Pasted outline", "image/svg+xml", '<svg width="4" height="3"><path d="M0 0H4V3Z"/></svg>'],
  ["Pasted outline", "application/json", '{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,3],[0,0]]]}'],
  ["Pasted outline", "text/plain", "x,y\n0,0\n4,0\n4,3\n"],
  ["Pasted maps", "text/plain", "T1 0 0 0 0.16 0 0 0.01"],
  ["Pasted animation", "application/json", '{"frond":"space","packed":"x"}'],
])("a %s is what would be a file", async (name, type, text) => {
  const got = pasted(text);
  if (!("file" in got)) throw new Error("no file");
  expect([got.file.name, got.file.type, await got.file.text()]).toEqual([name, type, text]);
});

test("of any other text it is said what can be pasted", () => {
  expect(pasted("See https://example.org/#v=next for more")).toEqual({
    problem:
      "Frond cannot open the pasted text. You can paste a link to a Frond document, maps (rows of numbers, Fractint, flames, JSON) or an outline (SVG, CSV, GeoJSON).",
  });
  expect(pasted("1 ".repeat((8 << 20) + 1))).toEqual({
    problem: "The pasted text is longer than 16 million characters. Save it as a file and open that.",
  });
});

test("no text is nothing, and nothing is said", () => {
  expect(pasted(" \r\n")).toEqual({ nothing: true });
});
