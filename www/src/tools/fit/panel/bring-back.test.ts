import { expect, test } from "vitest";
import { bringBackWords } from "./bring-back";

test("what a stroke needs to bring back what surrounds a picture is said once", () => {
  const frame = { code: "surrounded", message: "A frame around the picture is left out." } as const;
  const blank = { code: "blank", message: "Nothing stands out." } as const;
  expect(bringBackWords([blank, frame], false)).toBeNull();
  expect(bringBackWords([frame], true)).toBe(
    "Switch off “Only what is painted” first: a stroke brings back no more than it covers otherwise.",
  );
  expect(bringBackWords([blank], true)).toBeNull();
});
