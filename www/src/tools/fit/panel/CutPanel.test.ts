import { expect, test } from "vitest";
import { bringBackWords } from "./CutPanel";

test("what a stroke needs to bring back what surrounds a picture is said once", () => {
  const frame = { code: "surrounded", message: "A frame around the picture is left out." } as const;
  const blank = { code: "blank", message: "Nothing stands out." } as const;
  expect(bringBackWords([blank, frame], false)).toBeNull();
  expect(bringBackWords([frame], true)).toBe(
    "Turn off “Do not spread” first. With it, a stroke brings back only what it covers.",
  );
  expect(bringBackWords([blank], true)).toBeNull();
});
