import { expect, it } from "vitest";
import type { Answers } from "../answers";
import { arrivalWords, arrive, mostOf, problemLines, reportOf } from "./arrive";

const answers = (name: string, day: number, answer = "", title = "M"): Answers => ({
  name,
  title,
  saved: `2026-01-0${day}T10:00:00Z`,
  items: [
    { item: "e1", done: true, exercises: [1], guess: "0.4", right: true, truth: "0.4", answer },
    { item: "e2", done: false, exercises: [], guess: "", answer: "" },
  ],
});

it("takes the later answers of a pupil, and says what became of each", () => {
  const { all, arrivals } = arrive(
    [answers("Ada", 1, "first"), answers("Ben", 3, "third")],
    [answers("Ada", 2, "second"), answers("Ben", 2, "second"), answers("Cem", 2), answers("Cem", 4)],
  );
  expect(all.map(({ name, items }) => [name, items[0]?.answer])).toEqual([
    ["Ada", "second"],
    ["Ben", "third"],
    ["Cem", ""],
  ]);
  expect(arrivals.map(arrivalWords)).toEqual([
    "Ada: 1 of 2 done, in place of earlier answers.",
    "Ben: the table has later answers, which stay.",
    "Cem: 1 of 2 done.",
    "Cem is in the table already.",
  ]);
});

it("does not mix answers to another sheet in, and says whose they are", () => {
  const found = [answers("Ada", 1), answers("Ben", 1, "", "Ferns"), answers("Cem", 1)];
  expect(mostOf(found)).toBe("M");
  expect(mostOf([])).toBeUndefined();
  const { arrivals } = arrive([answers("Ada", 1)], found);
  expect(reportOf(arrivals, "M").map(({ words }) => words)).toEqual([
    "Cem added to “M”.",
    "Ada: in the table already.",
    "Ben answered another sheet, “Ferns”, which has a table of its own.",
  ]);
});

it("names a few pupils and counts many", () => {
  const some = (count: number) =>
    reportOf(
      arrive(
        [],
        Array.from({ length: count }, (_, i) => answers(`P${i}`, 1)),
      ).arrivals,
      "M",
    )[0]?.words;
  expect([some(1), some(2), some(3), some(30)]).toEqual([
    "P0 added to “M”.",
    "P0 and P1 added to “M”.",
    "P0, P1 and P2 added to “M”.",
    "30 pupils added to “M”.",
  ]);
});

it("says what to do about codes that cannot be taken", () => {
  const lines = (damaged: number, later: number) =>
    problemLines({ damaged, later, more: false }).map(({ words }) => words);
  expect(lines(0, 0)).toEqual([]);
  expect(lines(1, 0)).toEqual(["One code was cut or changed on its way. Ask for it again."]);
  expect(lines(0, 2)[0]).toMatch(/^2 codes come from a later version/);
});
