import { expect, test } from "vitest";
import { degrees, frontWords, pointWords, radians, shareWords, sideWords } from "./words";

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
