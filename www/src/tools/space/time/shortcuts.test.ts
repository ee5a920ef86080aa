import { expect, it } from "vitest";
import type { Focus } from "#ui/focus";
import { timeCommandOf } from "./shortcuts";

const press = (key: string, more: Partial<KeyboardEvent> = {}) => ({
  key,
  shiftKey: false,
  ctrlKey: false,
  metaKey: false,
  altKey: false,
  ...more,
});

it("plays with the space bar, but not where a button or a field has it", () => {
  const all: Focus[] = ["none", "slider", "control", "field", "typing"];
  expect(all.map((focus) => timeCommandOf(press(" "), focus))).toEqual(["play", "play", null, null, null]);
});

it("sets keys and walks them", () => {
  expect(timeCommandOf(press("k"), "none")).toBe("key");
  expect(timeCommandOf(press("K", { shiftKey: true }), "control")).toBe("key");
  expect(timeCommandOf(press(","), "none")).toBe("before");
  expect(timeCommandOf(press("."), "none")).toBe("after");
  expect(timeCommandOf(press("k", { ctrlKey: true }), "none")).toBeNull();
  expect(timeCommandOf(press("k"), "field")).toBeNull();
  expect(timeCommandOf(press("x"), "none")).toBeNull();
});
