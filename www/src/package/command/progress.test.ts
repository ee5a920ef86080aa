import { expect, test } from "vitest";
import { progress, timeLeft } from "./progress";

/** A clock that is set by hand, and what was said. */
function listener(watched: boolean) {
  const said: string[] = [];
  let at = 0;
  const system = {
    now: () => at,
    tell: (words: string) => said.push(words),
    ...(watched ? { rewrite: (words: string) => said.push(words) } : {}),
  };
  return {
    said,
    system: system as Parameters<typeof progress>[0],
    pass: (seconds: number) => (at += 1000 * seconds),
  };
}

test("one line is rewritten where somebody watches, and then taken away", () => {
  const { said, system, pass } = listener(true);
  const meter = progress(system);
  meter.say(0.01);
  pass(0.1);
  meter.say(0.02);
  pass(29.9);
  meter.say(0.25, "25 of 100 frames");
  meter.say(1);
  meter.end();
  expect(said).toEqual(["1 %", "25 of 100 frames, about 2 min left", ""]);
});

test("elsewhere a line comes now and then", () => {
  const { said, system, pass } = listener(false);
  const meter = progress(system);
  for (let second = 1; second <= 25; second++) {
    pass(1);
    meter.say(second / 100, `${second} of 100 frames`);
  }
  meter.end();
  expect(said).toEqual(["10 of 100 frames, about 2 min left", "20 of 100 frames, about 1 min left"]);
});

test("time is told as people say it", () => {
  expect([0.2, 42, 170, 3600, 4800].map(timeLeft)).toEqual([
    "about 1 s left",
    "about 42 s left",
    "about 3 min left",
    "about 1 h left",
    "about 1 h 20 min left",
  ]);
});
