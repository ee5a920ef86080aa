import { expect, test } from "vitest";
import { even, HIGH, LOW, numbersAt, placeOf } from "./numbers";

test("the slider ends where the numbers end, and every step of it is even", () => {
  expect([numbersAt(LOW), numbersAt(HIGH), numbersAt(-9), numbersAt(99)]).toEqual([12, 2000, 12, 2000]);
  for (let place = LOW; place <= HIGH; place += 0.037) expect(numbersAt(place) % 2).toBe(0);
  for (const n of [12, 46, 260, 1998, 2000]) expect(numbersAt(placeOf(n))).toBe(n);
  expect([even(13), even(260)]).toEqual([14, 260]);
});
