import { expect, test } from "vitest";
import type { Focus } from "#ui/focus";
import { commandOf, SHORTCUTS } from "./shortcuts";
import { stageCommand } from "./stage/keys";
import { timeCommandOf } from "./time/shortcuts";

type Held = Partial<Record<"shiftKey" | "ctrlKey" | "altKey", true>>;
const pressed = (key: string, held: Held = {}) => ({
  key,
  shiftKey: false,
  ctrlKey: false,
  metaKey: false,
  altKey: false,
  ...held,
});
const press = (key: string, focus: Focus = "none", held: Held = {}) => commandOf(pressed(key, held), focus);

test("keys are commands, but not while something is typed", () => {
  expect(press("2")).toEqual({ do: "hand", by: "turn" });
  expect(press("f")).toEqual({ do: "whole" });
  expect(press("o", "typing")).toBeNull();
  expect(press("o", "field")).toBeNull();
  expect(press("z", "field", { ctrlKey: true })).toEqual({ do: "undo" });
  expect(press("Z", "none", { shiftKey: true })).toEqual({ do: "redo" });
  expect(press("w")).toBeNull();
});

test("every single key of the list does something somewhere", () => {
  for (const { keys } of SHORTCUTS.flatMap((group) => group.rows)) {
    for (const way of keys) {
      const [key = ""] = way;
      if (way.length > 1 || !/^[A-Z0-9?[\]+]$/.test(key)) continue;
      const event = pressed(key.toLowerCase());
      const found = commandOf(event, "none") ?? stageCommand(event) ?? timeCommandOf(event, "none");
      expect(found, key).not.toBeNull();
    }
  }
});
