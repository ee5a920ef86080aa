import { expect, it } from "vitest";
import { ANSWERS, slideOfStep, slidesOf, stepOfSlide } from "./on-slides";
import { clockWords, secondsLeft } from "./timer";

it("shows the words and the picture of a lesson together", () => {
  expect(slidesOf(["text", "picture", "question", "exercise-1"])).toEqual([
    ["text", "picture"],
    ["question"],
    ["exercise-1"],
  ]);
  expect(slidesOf(["text"])).toEqual([["text"]]);
  expect(slidesOf([])).toEqual([]);
});

it("leads from a link to the same step as ever", () => {
  expect([1, 2, 3, 4, 5].map(slideOfStep)).toEqual([0, 0, 1, 2, 3]);
  for (const at of [0, 1, 2, 9]) expect(slideOfStep(stepOfSlide(at))).toBe(at);
});

it("shows no answers of the page, and what else it is set to", () => {
  for (const name of ["guess", "shown", "hints", "x1.second", "x12.a"])
    expect(ANSWERS.test(name), name).toBe(true);
  for (const name of ["lens", "n", "guesses", "at", "X1"]) expect(ANSWERS.test(name), name).toBe(false);
});

it("counts down whole seconds, and stands while it is paused", () => {
  expect([
    secondsLeft(180_000, null, 9),
    secondsLeft(180_000, 1000, 1001),
    secondsLeft(5000, 0, 9000),
  ]).toEqual([180, 180, 0]);
  expect([180, 59, 0, 5400].map(clockWords)).toEqual(["3:00", "0:59", "0:00", "90:00"]);
});
