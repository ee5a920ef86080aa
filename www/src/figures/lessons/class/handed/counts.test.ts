import { expect, it } from "vitest";
import type { Answer, Answers } from "../answers";
import { countsOf } from "./counts";

const class_ = (guesses: readonly (readonly [guess: string, right?: boolean])[], truth?: string): Answers[] =>
  guesses.map(([guess, right], i) => ({
    name: `P${i}`,
    title: "M",
    saved: "",
    items: [
      {
        item: "e1",
        done: guess !== "",
        exercises: [],
        guess,
        ...(right === undefined ? {} : { right }),
        ...(right === undefined || truth === undefined ? {} : { truth }),
        answer: "",
      } satisfies Answer,
      { item: "shape:gasket", done: true, exercises: [], guess: "", answer: "" },
    ],
  }));

it("counts what was chosen, with what is so though nobody chose it", () => {
  const all = class_([["b", false], ["a", false], ["b", false], [""]], "c");
  expect(countsOf(all)).toEqual([
    {
      item: "e1",
      guessed: 3,
      asked: 4,
      right: 0,
      counts: [
        { label: "b", count: 2, so: false },
        { label: "a", count: 1, so: false },
        { label: "c", count: 0, so: true },
      ],
    },
  ]);
});

it("puts a few numbers one by one, in their order, and says nothing of what is right where that is not known", () => {
  expect(countsOf(class_([["10"], ["2"], ["10"]]))[0]).toMatchObject({
    right: null,
    counts: [
      { label: "2", count: 1 },
      { label: "10", count: 2 },
    ],
  });
});

it("puts many numbers in round steps that leave none out", () => {
  const guesses = Array.from({ length: 30 }, (_, i) => [(0.25 + i * 0.008).toFixed(3), i === 19] as const);
  const [found] = countsOf(class_(guesses, "0.4"));
  expect(found?.counts.map(({ label }) => label)).toEqual([
    "0.25 to 0.30",
    "0.30 to 0.35",
    "0.35 to 0.40",
    "0.40 to 0.45",
    "0.45 to 0.50",
  ]);
  expect(found?.counts.reduce((sum, { count }) => sum + count, 0)).toBe(30);
  expect(found?.counts.filter(({ so }) => so).map(({ label }) => label)).toEqual(["0.40 to 0.45"]);
  // On a border it is the lower end of a step, and 0.3 / 0.05 is a little less than 6.
  expect(countsOf(class_([...guesses, ["0.3", false]], "0.4"))[0]?.counts[1]?.count).toBe(
    (found?.counts[1]?.count ?? 0) + 1,
  );
  for (const far of ["1000000", "0.000001", "-5"]) {
    const counts = countsOf(class_([...guesses, [far, false]], "0.4"))[0]?.counts ?? [];
    expect(counts.length).toBeLessThanOrEqual(11);
    expect(counts.reduce((sum, { count }) => sum + count, 0)).toBe(31);
  }
});

it("has nothing for what nobody guessed", () => {
  expect(countsOf(class_([[""], [""]]))).toEqual([]);
  expect(countsOf([])).toEqual([]);
});
