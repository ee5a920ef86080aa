import { afterEach, expect, test } from "vitest";
import { awaited, cancelled, fail, problem, running } from "./progress";

afterEach(() => {
  problem.value = null;
  cancelled.value = false;
  running.value = null;
});

test("a first fit is awaited before it is begun and while it is under way", () => {
  expect(awaited.value).toBe(true);
  running.value = { stage: "begin", share: 0 };
  expect(awaited.value).toBe(true);
});

test("none is awaited where it failed or was stopped", () => {
  running.value = { stage: "begin", share: 0 };
  fail(new Error("The points enclose no area."));
  expect([awaited.value, problem.value]).toEqual([false, "The points enclose no area."]);
  problem.value = null;
  cancelled.value = true;
  expect(awaited.value).toBe(false);
});
