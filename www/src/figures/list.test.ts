import { describe, expect, it } from "vitest";
import { Frame } from "./kit/frame/frame";
import { find, ROWS } from "./list";

const FIGURES = ROWS.flatMap(({ figures }) => figures);

describe.each(FIGURES)("$number", (figure) => {
  it("says what it is", () => {
    for (const words of [figure.number, figure.short, figure.title]) expect(words).toMatch(/\S/);
    // One line for the index is a sentence.
    expect(figure.about).toMatch(/^\p{Lu}.*[.?]$/u);
  });

  it("has a page and a small picture", async () => {
    expect((await figure.load()).Page).toBeTypeOf("function");
    expect((await figure.thumb()).Thumb).toBeTypeOf("function");
  });

  it("is where its addresses lead", () => {
    for (const id of [figure.id, ...(figure.also ?? [])]) {
      expect(id).toMatch(/^[a-z0-9-]+$/);
      expect(find(id)?.figure).toBe(figure);
    }
  });
});

it("gives no address and no page twice", async () => {
  const ids = FIGURES.flatMap(({ id, also = [] }) => [id, ...also]);
  expect(new Set(ids).size).toBe(ids.length);
  const pages = await Promise.all(FIGURES.map((figure) => figure.load()));
  expect(new Set(pages).size).toBe(FIGURES.length);
});

it("keeps the addresses that were given out", () => {
  const kept = "1 2 3 4 5 6 7 table-1 d1 d2 d3 d4 d5 d6 c1 c2 ct1 ct2 c3 c4 c5 c6 ct3 c7".split(" ");
  const space = "s1 s2 s3 s4 s5 s6 s7 s8 s35 s9".split(" ");
  const lessons = Array.from({ length: 11 }, (_, i) => `e${i + 1}`);
  for (const id of [...kept, ...space, ...lessons]) expect(find(id), id).not.toBeNull();
});

it.each([
  ["what was not printed", "The colours are Frond’s.", undefined, "reconstructed"],
  ["what was printed", null, undefined, "as printed"],
  ["what is Frond’s own", "Hardly anything was printed.", true, "Frond’s own"],
])("labels %s", (_, reconstructed, own, badge) => {
  const heading = { number: "Figure 0", title: "None" };
  const frame = Frame({
    ...heading,
    lead: "",
    children: "",
    parameters: [],
    captions: [],
    reconstructed,
    ...(own ? { own } : {}),
  });
  expect(JSON.stringify(frame, (key, value) => (key.startsWith("_") ? undefined : value))).toContain(
    `"badge":"${badge}"`,
  );
});
