import { expect, test } from "vitest";
import { NIGHT, PAPER } from "#style/colours";
import { isDark } from "#style/ground";
import {
  choiceOf,
  chosenBackground,
  degrees,
  frontWords,
  groundOf,
  pointWords,
  radians,
  shareWords,
  sideWords,
} from "./light";

test("the background of the document is shown whatever the page is like", () => {
  for (const page of [PAPER, NIGHT]) {
    expect(groundOf("#123456", page)).toBe("#123456");
    expect(groundOf(NIGHT, page)).toBe(NIGHT);
    expect(groundOf("page", page)).toBe(page);
    expect(groundOf(undefined, page)).toBe(page);
  }
});

test("every choice is what is read back of it", () => {
  for (const ground of [PAPER, NIGHT, "#88aadd"]) {
    for (const choice of ["paper", "night", "own", "page"] as const) {
      expect(choiceOf(chosenBackground(choice, ground))).toBe(choice);
    }
  }
  expect(choiceOf(undefined)).toBe("page");
});

test("light colours are for dark grounds", () => {
  expect([NIGHT, "#000000", "#203050"].map(isDark)).toEqual([true, true, true]);
  expect([PAPER, "#ffffff", "#cfe3f5"].map(isDark)).toEqual([false, false, false]);
});

test("it says where the light comes from", () => {
  expect(sideWords(0)).toBe("from above");
  expect(sideWords(radians(-40))).toBe("from above, 40° to the left");
  expect(sideWords(radians(90))).toBe("from the right");
  expect(sideWords(radians(-150))).toBe("from below, 30° to the left");
  expect(sideWords(Math.PI)).toBe("from below");
});

test("it says how far it stands before the picture", () => {
  expect(frontWords(0)).toBe("grazing");
  expect(frontWords(0.5)).toBe("50 % on the viewer’s side");
  expect(frontWords(1)).toBe("from the viewer");
});

test("numbers come out as they went in", () => {
  expect(degrees(radians(37))).toBeCloseTo(37, 12);
  expect(shareWords(0, "no fog")).toBe("no fog");
  expect(shareWords(0.35, "no fog")).toBe("35 %");
  expect(pointWords([1.23456, -1e-17, 2])).toBe("(1.235, 0, 2)");
});
