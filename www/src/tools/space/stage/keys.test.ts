import { expect, test } from "vitest";
import type { KeyPress } from "#ui/focus";
import { stageCommand } from "./keys";

const press = (key: string, held: Partial<KeyPress> = {}) =>
  stageCommand({ key, code: "", shiftKey: false, ctrlKey: false, metaKey: false, altKey: false, ...held });

test("arrows do what the hand does, and shift what is seen with Shift", () => {
  expect(press("ArrowLeft")).toEqual({ do: "hand", right: -1, down: 0 });
  expect(press("ArrowDown", { shiftKey: true })).toEqual({ do: "pan", right: 0, down: 1 });
});

test("letters fly, slowly with Shift, and leave the browser its chords", () => {
  expect(press("w")).toEqual({ do: "fly", right: 0, up: 0, ahead: 1 });
  expect(press("W", { shiftKey: true })).toEqual({ do: "fly", right: 0, up: 0, ahead: 0.1 });
  expect(press("w", { ctrlKey: true })).toBeNull();
  expect(press("a", { altKey: true })).toBeNull();
  expect(press("x")).toBeNull();
  expect(press("ц", { code: "KeyW" })).toEqual(press("w"));
});

test("plus nears, a comma narrows the angle, and each has its other way", () => {
  for (const [one, other] of [
    ["+", "-"],
    [",", "."],
  ] as const) {
    const [there, back] = [press(one), press(other)];
    if (!there || !back || !("factor" in there) || !("factor" in back)) throw new Error(one);
    expect(there.do).toBe(back.do);
    expect(there.factor * back.factor).toBeCloseTo(1, 12);
  }
  expect(press("+")).toMatchObject({ do: "near", factor: 1.15 });
  expect(press(",")?.do).toBe("angle");
});
