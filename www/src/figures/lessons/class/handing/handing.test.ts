import { describe, expect, it } from "vitest";
import type { Answer, Answers } from "../answers";
import { written } from "../answers";
import { asFigures, asWord, bytesOf, lengthOf } from "./code";
import { codesIn } from "./find";
import { packed, unpacked } from "./pack";

const item = (item: string, more: Partial<Answer> = {}): Answer => ({
  item,
  done: true,
  exercises: [],
  guess: "",
  answer: "",
  ...more,
});

const ADA: Answers = {
  name: "Ada Łukasz-Müller 🌿",
  title: "Class 9b, “M” & more",
  saved: "2026-11-24T10:00:07.000Z",
  items: [
    item("e1", {
      exercises: [1, 3],
      guess: "0.42",
      right: false,
      truth: "0.4",
    }),
    item("e22", { guess: "The plain bend", right: true, truth: "The plain bend", answer: "Zwei\nZeilen" }),
    item("e9999", { done: false }),
    item("shape:gasket", { answer: "a\0b".replace("\0", " ") }),
    item("link:12", { name: "Where do they part?", done: false }),
  ],
};

/** Six lessons as a class answers them: half of the guesses wrong, a few words to each. */
const USUAL: Answers = {
  name: "Charlotte Bernhardt",
  title: "Class 9b, fractals",
  saved: "2026-11-24T10:00:07.000Z",
  items: [
    ["e12", "Half of it: the shapes are alike, but one is clearly thicker", "They look the same"],
    ["e13", "Every stem: that of the fern, of each leaf, and of each leaflet on it", ""],
    ["e2", "A triangle in the middle", "there are holes everywhere"],
    ["e16", "B, the middle of the bottom", "It was C"],
    ["e1", "0.42", "They part below 0.4"],
    ["e17", "Three times as many", "It is not a line and not a square"],
  ].map(([key = "", guess = "", answer = ""], i) =>
    item(key, {
      exercises: [1, 2],
      guess,
      right: i % 2 === 1,
      truth: i % 2 === 1 ? guess : "Hardly anything: one could not tell which start it was",
      answer,
    }),
  ),
};

const wordOf = (answers: Answers) => `answers=${asWord(packed(answers))}`;

describe("a code", () => {
  it.each([0, 1, 2, 31, 32, 33, 64, 700])("of %i bytes is read as it was written", (count) => {
    const bytes = Uint8Array.from({ length: count }, (_, i) => (i * 167 + 255) & 255);
    for (const form of [asWord, asFigures]) {
      const code = form(bytes);
      expect(code).toMatch(/^[A-Za-z0-9]+$/);
      expect(lengthOf(code)).toBe(code.length);
      expect(bytesOf(code)).toEqual(bytes);
      expect(bytesOf(code.slice(0, -1))).toBeNull();
      expect(bytesOf(`${code}0`)).toBeNull();
    }
  });

  it("holds all of a pupil's answers", () => {
    expect(unpacked(packed(ADA))).toEqual(ADA);
    const whole = { ...ADA, items: [item("e1", { answer: "ü".repeat(4000) })] };
    expect(unpacked(packed(whole))).toEqual(whole);
    expect(unpacked(packed({ ...ADA, items: [] }))).toEqual({ ...ADA, items: [] });
  });

  it("of a usual sheet fits a QR code that is read at arm's length", () => {
    // So many figures fit one of version 10, of level L.
    expect(asFigures(packed(USUAL)).length).toBeLessThanOrEqual(652);
  });

  it("that was made once is read for ever", () => {
    const code =
      "answers=A02RUkVb8PPWeONvlA0hElRlslOc3hQGcbqbERSxuQq4MG2bJIxdimzm7ouAoYBngXlDFdgqCa32Rf6fPNgFzradSqaOmgCncslhg0kFXTrCy6XTK5UB39HEgUdVERd2dJBa85qPraWVAVtfZIHmqvdlntI";
    expect(codesIn(code).answers).toEqual([ADA]);
  });

  it("is not read where a sign is missing, other or too much", () => {
    const word = asWord(packed(USUAL));
    for (let at = 0; at < word.length; at += 3) {
      const others = [
        word.slice(0, at) + word.slice(at + 1),
        `${word.slice(0, at)}x${word.slice(at)}`,
        word.slice(0, at) + (word[at] === "k" ? "j" : "k") + word.slice(at + 1),
      ];
      for (const other of others)
        if (other !== word) expect(codesIn(`answers=${other}`).answers, other).toEqual([]);
    }
    expect(codesIn(`answers=${word.slice(0, 40)}`)).toMatchObject({ answers: [], damaged: 1 });
  });

  it("that is no code of answers breaks nothing", () => {
    for (let seed = 0; seed < 300; seed++) {
      const bytes = Uint8Array.from({ length: seed % 60 }, (_, i) => (seed * 31 + i * i * 17) & 255);
      expect(typeof unpacked(bytes)).toBe("string");
    }
    expect(unpacked(Uint8Array.from([9, 1, 2, 3, 4, 5, 6, 7, 8, 9]))).toBe("later");
  });
});

describe("in a text", () => {
  const ben = { ...USUAL, name: "Ben" };

  it("all codes are found, whatever stands around them", () => {
    const text = `On Tuesday Ada <ada@school.example> wrote:
> Here: https://frond.example/some/#learn/class/${wordOf(ADA)}.
> and this is Ben's: "${wordOf(ben)}"

my answers=yes, all answers=Everything
Charlotte\t${asFigures(packed(USUAL)).replace(/^/, "https://x/#learn/class/answers=")}\tlate`;
    const found = codesIn(text);
    expect(found.answers.map(({ name }) => name)).toEqual([ADA.name, "Ben", USUAL.name]);
    expect(found).toMatchObject({ damaged: 0, later: 0, more: false });
  });

  it("a code is put together that a mail has broken into lines and quoted, or wrapped in another link", () => {
    const broken = `${wordOf(ADA)
      .match(/.{1,40}/g)
      ?.join("=\r\n> > ")}\nBen ${wordOf(ben)}`;
    expect(codesIn(broken).answers).toEqual([ADA, ben]);
    const early = wordOf(ADA);
    expect(codesIn(`${early.slice(0, 10)}\n> ${early.slice(10)}`).answers).toEqual([ADA]);
    const safe = `https://safe.example/?url=${encodeURIComponent(`https://x/#learn/class/${wordOf(ADA)}`)}&data=05`;
    expect(codesIn(safe).answers).toEqual([ADA]);
  });

  it("one that was cut does not hide the next", () => {
    const found = codesIn(`${wordOf(ADA).slice(0, 90)}\n${wordOf(ben)}`);
    expect(found).toMatchObject({ answers: [ben], damaged: 1 });
  });

  it("one of a later version is told", () => {
    expect(codesIn(wordOf(ADA).replace("=A", "=B"))).toMatchObject({ answers: [], later: 1 });
  });

  it("the text of a file and the figures of a QR code are answers, and other codes are none", () => {
    expect(codesIn(written(ADA)).answers).toEqual([ADA]);
    expect(codesIn(asFigures(packed(ADA))).answers).toEqual([ADA]);
    for (const other of ["https://example.org/", "WIFI:S:x;;", "9".repeat(80), "", "{}"])
      expect(codesIn(other)).toEqual({ answers: [], damaged: 0, later: 0, more: false });
  });

  it("of a million lines, the few are found, and of too many codes the first are", () => {
    const lines = `${"a line that is none answers=\n".repeat(1e6)}${wordOf(ADA)}`;
    expect(codesIn(lines).answers).toEqual([ADA]);
    const many = Array.from({ length: 2100 }, (_, i) => wordOf({ ...ADA, items: [], name: `P${i}` })).join(
      "\n",
    );
    const found = codesIn(many);
    expect([found.answers.length, found.more]).toEqual([2000, true]);
  });
});
