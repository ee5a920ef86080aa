import { expect, it } from "vitest";
import type { Space, SpaceView } from "#wasm/api";
import { readSaved, savedText } from "./saved";

const view: SpaceView = { target: [1, 2, 3], distance: 4, turn: 0.1, tilt: 0.2, angle: 0.9, holds: "eye" };
const space = { objects: [], light: {} } as unknown as Space;

it("reads what it writes", () => {
  expect(readSaved(savedText({ packed: "abc", at: 1.5, view, space }))).toEqual({
    packed: "abc",
    at: 1.5,
    view,
  });
  expect(readSaved(savedText({ packed: "abc", at: 0, space }))).toEqual({ packed: "abc", at: 0 });
});

it("says what is wrong with other files", () => {
  const problem = (text: string) => {
    const read = readSaved(text);
    return "problem" in read ? read.problem : "";
  };
  expect(problem("<svg>")).toContain("not a JSON");
  expect(problem("null")).toContain("no animation");
  expect(problem('{"frond":"space"}')).toContain("no animation");
  expect(problem('{"fps":30,"frames":[]}')).toContain("no frame");
});

it("leaves out a view and a moment that are none", () => {
  const text = (more: object) => JSON.stringify({ frond: "space", packed: "x", ...more });
  expect(readSaved(text({ at: -1, view: { ...view, distance: 0 } }))).toEqual({ packed: "x", at: 0 });
  expect(readSaved(text({ at: "1", view: { ...view, target: [1, 2] } }))).toEqual({ packed: "x", at: 0 });
  expect(readSaved(text({ view: { ...view, angle: 4 } }))).toEqual({ packed: "x", at: 0 });
});
