import { describe, expect, it } from "vitest";
import { type Answers, askedOf, latest, read, written } from "./answers";
import { itemsWithNames } from "./names";
import {
  EMPTY,
  fits,
  itemsOf,
  linksIn,
  moved,
  type Numbered,
  numbered,
  type Sheet,
  sheetAddress,
  sheetIn,
  sheetKept,
  sheetOfKept,
  sheetOfLink,
  withoutHiding,
} from "./sheet";

const SHEET: Sheet = {
  title: "Class 9b, “M” & more",
  lessons: ["e12", "e7"],
  shapes: ["gasket"],
  links: ["learn/e7/at=question&guess=0.3", "v=1&a=koch"],
  numbers: [1, 2],
  names: { "link:2": "From gasket to Koch" },
  tasks: { e7: "When do they part? <b>&", "shape:gasket": "Drei Äpfel" },
  order: [],
  hide: false,
};

describe("a sheet", () => {
  it("is read from its address as it was written", () => {
    expect(sheetIn(sheetAddress(SHEET))).toEqual({ sheet: SHEET, whole: true });
    expect(itemsOf(SHEET)).toEqual(["e12", "e7", "shape:gasket", "link:1", "link:2"]);
  });

  it.each(["", "title=x", "lessons=", "<script>", "%", "lessons=../x"])("is not in %s", (state) => {
    expect(sheetIn(state)).toBeNull();
  });

  it("says when a part of it was lost", () => {
    const found = sheetIn("lessons=e1,e2&shapes=a%20b");
    expect(found).toEqual({ sheet: { ...EMPTY, lessons: ["e1", "e2"] }, whole: false });
  });

  it("keeps words for what is on it, a line of so many letters each", () => {
    const tasks = { e12: `a\nb ${"x".repeat(300)}`, e9: "not on it", e7: "  " };
    const found = sheetIn(sheetAddress({ ...SHEET, tasks }))?.sheet.tasks ?? {};
    expect(Object.keys(found)).toEqual(["e12"]);
    expect(found["e12"]).toBe(`a b ${"x".repeat(136)}`);
  });

  it("keeps what links are called, and no more names than there are links", () => {
    const names = {
      "link:1": "  ",
      "link:2": `a\nb ${"x".repeat(300)}`,
      "link:3": "not on it",
      e7: "no link",
    };
    const found = sheetIn(sheetAddress({ ...SHEET, names }))?.sheet.names ?? {};
    expect(Object.keys(found)).toEqual(["link:2"]);
    expect(found["link:2"]).toBe(`a b ${"x".repeat(56)}`);
    expect(
      itemsWithNames({ ...SHEET, shapes: [] })
        .map(({ name }) => name)
        .slice(2),
    ).toEqual(["Lesson 18, Straight on, or led, as it was set", "From gasket to Koch"]);
  });

  it("is told from what no link holds", () => {
    expect(fits(SHEET)).toBe(true);
    const links = Array.from({ length: 8 }, (_, i) => `v=${i}&a=${"1".repeat(800)}`);
    expect(fits({ ...SHEET, links, numbers: [1, 2, 3, 4, 5, 6, 7, 8] })).toBe(false);
  });

  it("in the making is kept as far as it goes, and opened from its link", () => {
    for (const sheet of [EMPTY, SHEET, { ...EMPTY, title: "Only a title" }]) {
      expect(sheetOfKept(sheetKept(sheet))).toEqual(sheet);
    }
    for (const text of [null, "", "{", "[]", "null", '{"lessons":7}', '"x"']) {
      expect(sheetOfKept(text)).toEqual(EMPTY);
    }
    expect(sheetOfLink(` https://x/y/#learn/sheet/${sheetAddress(SHEET)} `)).toEqual(SHEET);
    expect(sheetOfLink("https://x/#learn/e7")).toBeNull();
  });

  it("takes links of Frond, and tells what is none", () => {
    expect(
      linksIn(
        "https://frond.example/#learn/e1/at=question\n  http://x/some/#v=1&a=gasket  \nhello http://x/",
      ),
    ).toEqual({ links: ["learn/e1/at=question", "v=1&a=gasket"], wrong: ["hello", "http://x/"] });
    expect(linksIn(`http://x/#v=1&a=${"1".repeat(2000)}`).wrong.length).toBe(1);
    expect(linksIn("http://x/#v=1 ".repeat(20)).links.length).toBe(8);
  });
});

describe("the order of a sheet", () => {
  const MIXED = { ...SHEET, order: ["shape:gasket", "link:2", "e12", "e7", "link:1"], hide: true };

  it("is in its address, and what it hides", () => {
    expect(sheetIn(sheetAddress(MIXED))).toEqual({ sheet: MIXED, whole: true });
    expect(itemsOf(MIXED)).toEqual(MIXED.order);
    expect(
      itemsWithNames({ ...MIXED, shapes: [], order: ["link:2", "e12", "e7", "link:1"] }).map(
        ({ href }) => href,
      ),
    ).toEqual([
      "#v=1&a=koch",
      "#learn/e12/hide=1",
      "#learn/e7/hide=1",
      "#learn/e7/at=question&guess=0.3&hide=1",
    ]);
  });

  it("is changed an item at a time, and keeps to its ends", () => {
    const up = moved(SHEET, "shape:gasket", -1);
    expect(itemsOf(up)).toEqual(["e12", "shape:gasket", "e7", "link:1", "link:2"]);
    expect(itemsOf(moved(up, "e12", -1))).toEqual(itemsOf(up));
    expect(itemsOf(moved(up, "e12", 9)).at(-1)).toBe("e12");
    expect(sheetAddress(moved(up, "shape:gasket", 1))).toBe(sheetAddress(SHEET));
  });

  it("has what is added since at its end, and nothing that was taken off", () => {
    expect(itemsOf({ ...MIXED, lessons: ["e7", "e1"], shapes: [] })).toEqual([
      "link:2",
      "e7",
      "link:1",
      "e1",
    ]);
  });

  it("that is damaged is the usual one, which is said", () => {
    for (const order of ["1", "1,1", "2,9", "x"]) {
      expect(sheetIn(`lessons=e1,e2&order=${order}`), order).toMatchObject({
        sheet: { order: [] },
        whole: false,
      });
    }
  });

  it("is another link for the same work where answers are shown", () => {
    expect(withoutHiding(sheetAddress(MIXED))).toBe(sheetAddress({ ...MIXED, hide: false }));
    expect(withoutHiding(sheetAddress(SHEET))).toBe(sheetAddress(SHEET));
  });
});

describe("a link of a sheet", () => {
  const known = new Map<string, number>();
  const change = (before: Numbered, ...links: string[]) => numbered(before, links, known);
  const three = { links: ["a=1", "b=2", "c=3"], numbers: [1, 2, 3] };

  it("keeps its number when others go, come, and change places", () => {
    const two = change(three, "a=1", "c=3");
    expect(two.numbers).toEqual([1, 3]);
    expect(change(two, "c=3", "new", "a=1").numbers).toEqual([3, 4, 1]);
    expect(change(two, "b=2", "a=1", "c=3", "b=2")).toEqual({
      links: ["b=2", "a=1", "c=3"],
      numbers: [2, 1, 3],
    });
  });

  it("keeps it when its line is changed, and no two have one", () => {
    const changed = change(three, "a=1", "b=22", "c=3");
    expect(changed.numbers).toEqual([1, 2, 3]);
    const { numbers } = change(changed, "b=2", "a=1", "b=22", "c=3");
    expect(numbers.slice(1)).toEqual([1, 2, 3]);
    expect(new Set(numbers).size).toBe(4);
  });

  it("has a number that a sheet can hold, however often links came and went", () => {
    let sheet: Numbered = { links: [], numbers: [] };
    for (let i = 0; i < 300; i++) sheet = change(sheet, ...sheet.links.slice(-3), `x=${i}`);
    expect(new Set(sheet.numbers).size).toBe(4);
    for (const number of sheet.numbers) expect(number).toBeLessThan(100);
  });

  it("has its name and its task by it, in the address too", () => {
    const sheet: Sheet = {
      ...EMPTY,
      ...change(three, "c=3", "a=1"),
      names: { "link:2": "gone", "link:3": "Third" },
      tasks: { "link:1": "Look" },
    };
    const found = sheetIn(sheetAddress(sheet))?.sheet;
    expect(found).toEqual({ ...sheet, names: { "link:3": "Third" } });
    expect(itemsWithNames(found ?? EMPTY).map(({ key, name, task }) => [key, name, task])).toEqual([
      ["link:3", "Third", ""],
      ["link:1", "Link 1", "Look"],
    ]);
  });

  it("of an old sheet has that of its place, as where numbers are damaged", () => {
    const old = sheetIn("links=a%3D1%20b%3D2&names=link%3A2%20Two");
    expect(old).toMatchObject({ sheet: { numbers: [1, 2], names: { "link:2": "Two" } }, whole: true });
    for (const numbers of ["3", "2,2", "0,1", "x"]) {
      expect(sheetIn(`links=a%3D1%20b%3D2&numbers=${numbers}`), numbers).toMatchObject({
        sheet: { numbers: [1, 2] },
        whole: false,
      });
    }
  });
});

const ANSWERS: Answers = {
  name: "Ana",
  title: "M",
  saved: "2026-01-02T10:00:00Z",
  items: [
    {
      item: "e1",
      done: true,
      exercises: [1, 2],
      guess: "0.35",
      right: false,
      truth: "0.4",
      name: "Lesson 5",
      answer: "0.4",
    },
  ],
};

describe("a file of answers", () => {
  it("is read as it was written", () => {
    expect(read(written(ANSWERS))).toEqual(ANSWERS);
  });

  it.each([
    ["", /no JSON/],
    ["%PDF-1.7", /no JSON/],
    ["[]", /no file of answers/],
    ['{"kind":"other"}', /no file of answers/],
    ['{"kind":"frond answers","version":9,"items":[]}', /later version/],
    ['{"kind":"frond answers","version":1}', /damaged/],
    ['{"kind":"frond answers","version":1,"items":[{"item":"<b>","done":true,"exercises":[]}]}', /damaged/],
    [`{"kind":"frond answers","version":1,"items":[${"{},".repeat(500)}{}]}`, /damaged/],
  ])("is told from %s", (text, words) => {
    expect(read(text)).toMatch(words);
  });

  it("keeps what it holds within bounds", () => {
    const long = {
      ...ANSWERS,
      name: "x".repeat(500),
      items: [{ ...ANSWERS.items[0], answer: "y".repeat(9000) }],
    };
    const found = read(JSON.stringify({ kind: "frond answers", version: 1, ...long }));
    if (typeof found === "string") throw new Error(found);
    expect(found.name.length).toBe(80);
    expect(found.items[0]?.answer.length).toBe(4000);
  });
});

it("shows the latest of each name, and all that anybody was asked", () => {
  const later = { ...ANSWERS, saved: "2026-01-03T10:00:00Z", items: [] };
  const other = {
    ...ANSWERS,
    name: "Ben",
    items: [{ item: "e2", done: false, exercises: [], guess: "", answer: "" }],
  };
  expect(latest([later, ANSWERS, other])).toEqual([later, other]);
  expect(askedOf([ANSWERS, other])).toEqual(["e1", "e2"]);
});
