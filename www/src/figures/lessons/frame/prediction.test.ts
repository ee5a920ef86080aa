import { expect, it } from "vitest";
import { nearWords } from "./prediction";

it("says how near a guess came, without marks", () => {
  const bands = { close: 0.01, fair: 0.1 };
  expect(nearWords(0.5, 0.5, bands)).toBe("You saw it.");
  expect(nearWords(0.505, 0.5, bands)).toBe("You saw it.");
  expect(nearWords(0.45, 0.5, bands)).toBe("You were near.");
  expect(nearWords(0.2, 0.5, bands)).toBe("It is more than you thought.");
  expect(nearWords(0.8, 0.5, bands)).toBe("It is less than you thought.");
  expect(nearWords(5, 5, { close: 0, fair: 1 })).toBe("You saw it.");
});
