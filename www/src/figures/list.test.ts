import { describe, expect, it } from "vitest";
import { Frame } from "./kit/frame/frame";
import { LESSONS, UNITS } from "./lessons/course";
import { find, hrefOf, neighbours, ROWS, related } from "./list";

const FIGURES = [...ROWS, ...UNITS].flatMap(({ figures }) => figures);

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
  const kept = "1 2 3 4 5 6 7 table-1 d1 d2 d3 d4 d5 d6 d53 c1 c24 c2 ct1 ct2 c3 c4 c5 c6 ct3 c7 c43".split(
    " ",
  );
  const space = "s1 s2 s3 s4 s5 s6 s7 s8 s34 s35 s9 s10".split(" ");
  const lessons = Array.from({ length: 11 }, (_, i) => `e${i + 1}`);
  for (const id of [...kept, ...space, ...lessons]) expect(find(id), id).not.toBeNull();
});

/** A folder's own values in the address, by the names that are written out. */
it("gives no value of a page the name of another", async () => {
  const sources = import.meta.glob<string>("./*/**/*.tsx", { query: "?raw", import: "default" });
  const names = new Map<string, string[]>();
  for (const [file, load] of Object.entries(sources)) {
    const folder = file.replace(/\/[^/]*$/, "");
    const found = [...(await load()).matchAll(/useKept(?:<[^(]*>)?\(\s*"([^"]*)"/g)].map(
      ([, name = ""]) => name,
    );
    names.set(folder, [...(names.get(folder) ?? []), ...found]);
  }
  for (const [folder, all] of names) {
    expect(new Set(all).size, `${folder}: ${all}`).toBe(all.length);
    if (!folder.includes("/kit/") && !folder.endsWith("/frame")) expect(all).not.toContain("at");
  }
  expect([...names.values()].flat().length).toBeGreaterThan(40);
});

describe("the course", () => {
  const order = LESSONS.map(({ id }) => id);

  it("counts its lessons through its units, and has an address for each", () => {
    expect(LESSONS.map(({ short }) => short)).toEqual(order.map((_, i) => String(i + 1)));
    // Addresses of lessons are told from those of figures by their form.
    for (const lesson of LESSONS) expect(hrefOf(lesson)).toMatch(/^#learn\/e\d+$/);
    for (const { figures } of ROWS) for (const { id } of figures) expect(id).not.toMatch(/^e\d+$/);
  });

  it("asks for what comes before", () => {
    for (const { id, after } of LESSONS)
      for (const other of after) {
        expect(order, id).toContain(other);
        expect(order.indexOf(other), `${id} after ${other}`).toBeLessThan(order.indexOf(id));
      }
  });

  it("leads from its first lesson to its last", () => {
    const [first] = LESSONS;
    const way: string[] = [];
    for (let found = first && find(first.id); found; ) {
      way.push(found.figure.id);
      const { next } = neighbours(found);
      found = next ? find(next.id) : null;
    }
    expect(way).toEqual(order);
  });

  it("is linked with the figures both ways", () => {
    for (const lesson of LESSONS) {
      expect(related(lesson).map(({ id }) => id)).toEqual(lesson.figures);
      for (const figure of related(lesson)) expect(related(figure)).toContain(lesson);
    }
  });

  it("takes a few minutes a lesson", () => {
    for (const { id, minutes } of LESSONS) {
      expect(minutes, id).toBeGreaterThan(0);
      expect(minutes, id).toBeLessThanOrEqual(15);
    }
  });
});

it.each([
  ["what was not printed", "The colours are Frond’s.", undefined, "reconstructed"],
  ["what was printed", null, undefined, "as printed"],
  ["what is Frond’s own", "Hardly anything was printed.", true, "Frond’s own"],
])("labels %s", (_, reconstructed, own, badge) => {
  const heading = { id: "0", number: "Figure 0", title: "None" };
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

/** What nobody but a page of Frond would write, and what it might. */
const HOSTILE = [
  "",
  "0",
  "1",
  "-1",
  "2.5",
  "999999999",
  "1e9",
  "1e-99",
  "NaN",
  "Infinity",
  "0x10",
  "null",
  "own",
  "__proto__",
  "constructor",
  "1,1",
  "1,1,1",
  "0,0;0,0;0,0",
  "1,0;0.5,1;0,0",
  "0,0,0,0,0,0,0",
  "0,0,0,0,0,0,0;eye",
  "9,9,9,9,9,9,9;eye;eye",
  "a".repeat(3000),
  "1,".repeat(1500),
  "\u0000",
  "<b>",
  "٣",
];

describe("the address of a figure", () => {
  const figures = ROWS.flatMap((row) => row.figures);

  it.each(figures.map((figure) => [figure.number, figure] as const))(
    "%s has all that it is set to",
    async (_, figure) => {
      const { STATE = {} } = await figure.load();
      for (const [name, [first, field]] of Object.entries(STATE)) {
        // What is nothing at first is not written.
        if (first === null) continue;
        const text = field.write(first);
        expect(text.length, name).toBeLessThan(100);
        expect(field.read(text), `${name}=${text}`).toEqual(nearly(first));
      }
    },
  );

  it.each(figures.map((figure) => [figure.number, figure] as const))(
    "%s reads nothing else",
    async (_, figure) => {
      const { STATE = {} } = await figure.load();
      for (const [name, [, field]] of Object.entries(STATE))
        for (const text of HOSTILE) {
          const value = field.read(text);
          // What is read can be written, and is the same when it is read again.
          if (value !== null) expect(field.read(field.write(value)), `${name}=${text}`).toEqual(value);
        }
    },
  );

  it("knows every value that a page keeps", async () => {
    const sources = import.meta.glob<string>("./{burch-hart,fujimoto,cochran,darwish}/*/page.tsx", {
      query: "?raw",
      import: "default",
    });
    let count = 0;
    for (const [file, load] of Object.entries(sources)) {
      const source = await load();
      expect(source.match(/\buseState[<(]/g) ?? [], file).toHaveLength(SHORT_LIVED[file] ?? 0);
      for (const [, name, ...given] of source.matchAll(/useKept\("([^"]*)", \.\.\.STATE\.(\w+)\)/g)) {
        expect(given, file).toEqual([name]);
        count++;
      }
    }
    expect(count).toBeGreaterThan(50);
  });
});

/** States of pages that are no part of their address: what is measured, and what follows from what is kept. */
const SHORT_LIVED: Readonly<Record<string, number>> = {
  "./burch-hart/figure-2/page.tsx": 1,
  "./burch-hart/table-1/page.tsx": 4,
  "./darwish/figure-iv/page.tsx": 1,
};

/** As near as an address has it. */
function nearly(value: unknown): unknown {
  if (typeof value === "number") return Number.isInteger(value) ? value || 0 : expect.closeTo(value, 3);
  if (Array.isArray(value)) return value.map(nearly);
  if (value === null || typeof value !== "object") return value;
  return Object.fromEntries(Object.entries(value).map(([name, part]) => [name, nearly(part)]));
}
