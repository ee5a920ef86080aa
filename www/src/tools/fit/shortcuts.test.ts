import { expect, test } from "vitest";
import type { Focus } from "#ui/focus";
import { commandOf, SHORTCUTS } from "./shortcuts";

const press = (
  key: string,
  focus: Focus = "none",
  held: Partial<Record<"shiftKey" | "ctrlKey" | "altKey", true>> = {},
) => commandOf({ key, shiftKey: false, ctrlKey: false, metaKey: false, altKey: false, ...held }, focus);

test("letters are commands, but not while something is typed", () => {
  expect(press("c")).toEqual({ do: "compare" });
  expect(press("2")).toEqual({ do: "hand", by: "keep" });
  expect(press("c", "typing")).toBeNull();
  expect(press("2", "field")).toBeNull();
  expect(press("z", "field", { ctrlKey: true })).toEqual({ do: "undo" });
  expect(press("x")).toBeNull();
});

test("every single letter of the list does something", () => {
  for (const { keys } of SHORTCUTS.flatMap((group) => group.rows)) {
    for (const way of keys) {
      const [key = ""] = way;
      if (way.length === 1 && /^[A-Z0-9?[\]]$/.test(key)) expect(press(key.toLowerCase())).not.toBeNull();
    }
  }
});
