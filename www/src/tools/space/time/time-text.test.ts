import { expect, it } from "vitest";
import type { MapRow3, SpaceTimeline, SpaceView } from "#wasm/api";
import { EASES, easeWords, keyWords, LOOPS, loopOf, momentWords } from "./time-text";

const stay: MapRow3 = [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0];
const view: SpaceView = { target: [0, 0, 0], distance: 3, turn: 0, tilt: 0, angle: 1 };
const line: SpaceTimeline = {
  seconds: 6,
  loop: "round",
  course: "smooth",
  keys: [
    { at: 0, ease: "even", view },
    { at: 3, ease: "hold" },
  ],
};

it("says where in time it is", () => {
  expect(momentWords(line, 3)).toBe("3 s of 6 s, keyframe 2 of 2");
  expect(momentWords(line, 1.234)).toBe("1.23 s of 6 s, between keyframes");
  expect(momentWords(null, 0)).toBe("0 s, nothing moves");
});

it("says what a key holds", () => {
  expect(keyWords({ at: 0, ease: "even", view })).toBe("the view");
  expect(keyWords({ at: 0, ease: "even", view, moved: [stay, null, stay], maps: [[stay]], t: 0.25 })).toBe(
    "the view, 2 objects, the morph at 0.25",
  );
  expect(keyWords({ at: 0, ease: "even", moved: [null, stay] })).toBe("one object");
  expect(keyWords({ at: 0, ease: "even" })).toBe("nothing yet");
});

it("has a word for each way to go on", () => {
  expect(LOOPS.map(({ value }) => loopOf(value)?.label)).toEqual(["None", "Restart", "Back and forth"]);
});

it("has a word for each pace", () => {
  expect(new Set(EASES.map(({ label }) => label)).size).toBe(5);
  expect(easeWords("hold")).toBe("hold, then jump");
});
