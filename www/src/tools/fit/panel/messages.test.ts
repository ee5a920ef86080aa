import { expect, test } from "vitest";
import { bringBackWords } from "./messages";

test("it is said how what surrounds a picture comes back, by the controls that are there", () => {
  const frame = { code: "surrounded", message: "A frame around the picture is left out." } as const;
  const blank = { code: "blank", message: "Nothing stands out." } as const;
  expect(bringBackWords([blank, frame], false)).toBe(
    "To bring back what is left out, choose Leaf under Brush, and draw a stroke on it.",
  );
  expect(bringBackWords([frame], true)).toBe(
    "To bring back what is left out, choose Leaf under Brush, switch off “Only what is painted”, and draw a stroke on it.",
  );
  expect(bringBackWords([blank], false)).toBeNull();
});
