import { expect, it } from "vitest";
import { placeTyped } from "./type-ahead";

const names = ["Gasket", "Dragon", "Dragon of three", "Lévy curve", "Koch curve", "Carpet"];

it("finds a name by its first letters, without case and accents", () => {
  expect(placeTyped(names, 0, "k")).toBe(4);
  expect(placeTyped(names, 0, "le")).toBe(3);
  expect(placeTyped(names, 0, "LÉVY C")).toBe(3);
  expect(placeTyped(names, 5, "g")).toBe(0);
  expect(placeTyped(names, 0, "x")).toBe(-1);
  expect(placeTyped([], 0, "x")).toBe(-1);
});

it("stays where more letters still mean the same, and goes on where one is typed again", () => {
  expect(placeTyped(names, 0, "d")).toBe(1);
  expect(placeTyped(names, 1, "dr")).toBe(1);
  expect(placeTyped(names, 1, "dd")).toBe(2);
  expect(placeTyped(names, 2, "ddd")).toBe(1);
});
