import { expect, test } from "vitest";
import { Detail, HANDHELD, LEVELS } from "./detail";

const frames = (detail: Detail, count: number, waited: number) => {
  for (let i = 0; i < count; i++) detail.frame(waited);
  return detail.level;
};

test("less is drawn when frames are late again and again, not when one is", () => {
  const detail = new Detail();
  expect(frames(detail, 2, 60)).toEqual(LEVELS[0]);
  expect(frames(detail, 1, 16)).toEqual(LEVELS[0]);
  expect(frames(detail, 3, 60)).toEqual(LEVELS[1]);
});

test("a processor in the place of a graphics card is found out in a few frames", () => {
  expect(frames(new Detail(), 3, 900)).toEqual(LEVELS.at(-1));
});

test("more is drawn after a long time without trouble, and never more than at first", () => {
  const detail = new Detail(HANDHELD);
  expect(detail.level).toEqual(LEVELS[HANDHELD]);
  frames(detail, 3, 60);
  expect(frames(detail, 89, 16)).toEqual(LEVELS[HANDHELD + 1]);
  expect(frames(detail, 1, 16)).toEqual(LEVELS[HANDHELD]);
  expect(frames(detail, 500, 16)).toEqual(LEVELS[HANDHELD]);
});
