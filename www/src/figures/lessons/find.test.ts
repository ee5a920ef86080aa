import { expect, it } from "vitest";
import { LESSONS } from "./course";
import { lessonsWith } from "./find";

const idsOf = (asked: string) => lessonsWith(asked).map(({ id }) => id);

it("finds lessons by a word of their title, of their unit, or of what they are about", () => {
  expect(idsOf("fern")).toEqual(expect.arrayContaining(["e13", "e15"]));
  expect(idsOf("bending")).toEqual(["e11", "e22"]);
  expect(idsOf("Lesson 1")).toContain("e12");
});

it("takes the beginning of a word, capital letters and marks as they come, and words in any order", () => {
  expect(idsOf("SIERP")).toContain("e2");
  expect(idsOf("möran")).toContain("e17");
  expect(idsOf("set m")).toEqual(idsOf("M, set"));
  expect(idsOf("set m").length).toBeGreaterThan(0);
});

it("finds nothing where a word stands nowhere, and all of nothing is nothing", () => {
  expect(idsOf("fern zebra")).toEqual([]);
  expect(idsOf("ern")).toEqual([]);
  expect(idsOf("  ")).toEqual([]);
});

it("knows the words that Frond speaks in itself", () => {
  for (const asked of ["falls apart", "fall apart"])
    expect(idsOf(asked)).toEqual(expect.arrayContaining(["e1", "e7"]));
  expect(idsOf("one piece")).toEqual(expect.arrayContaining(["e1", "e5", "e3", "e8"]));
});

it("finds each lesson by its title", () => {
  for (const { id, title } of LESSONS) expect(idsOf(title), title).toContain(id);
});

it("takes a number as a whole one, and the lesson of that number first", () => {
  expect(idsOf("Lesson 2")[0]).toBe("e13");
  expect(idsOf("Lesson 2")).not.toContain("e21");
});

it("finds what is about connectedness by the plain words for it", () => {
  const about = ["e1", "e5", "e3", "e9", "e10", "e20", "e7", "e8", "e4", "e21"];
  for (const asked of [
    "connected",
    "falls apart",
    "fall apart",
    "holds together",
    "one piece",
    "in pieces",
    "broken",
  ]) {
    expect(idsOf(asked), asked).toEqual(expect.arrayContaining(about));
    // It is not the whole course.
    expect(idsOf(asked), asked).not.toContain("e13");
    expect(idsOf(asked), asked).not.toContain("e23");
  }
});
