import { expect, test } from "vitest";
import { NIGHT, PAPER } from "#style/colours";
import { isDark } from "#style/ground";
import { choiceOf, chosenBackground, groundOf } from "./background";

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
