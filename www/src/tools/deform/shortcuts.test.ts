import { describe, expect, it } from "vitest";
import type { Focus, KeyPress } from "#ui/focus";
import { commandOf, nextKey } from "./shortcuts";

const press = (key: string, held: Partial<KeyPress> = {}): KeyPress => ({
  key,
  shiftKey: false,
  ctrlKey: false,
  metaKey: false,
  altKey: false,
  ...held,
});

describe("commandOf", () => {
  it.each([
    [press(" "), "none", { do: "play" }],
    [press(" "), "slider", { do: "play" }],
    [press(" "), "control", null],
    [press("g"), "none", { do: "grid" }],
    [press("G"), "control", { do: "grid" }],
    [press("4"), "none", { do: "colour", by: "grid" }],
    [press("k"), "none", { do: "key" }],
    [press("k"), "typing", null],
    [press("k"), "field", null],
    [press("]"), "none", { do: "frame", by: 1 }],
    [press("ArrowLeft", { shiftKey: true }), "none", { do: "scrub", by: -0.001 }],
    [press("ArrowLeft"), "control", null],
    [press("z", { ctrlKey: true }), "field", { do: "undo" }],
    [press("Z", { ctrlKey: true, shiftKey: true }), "none", { do: "redo" }],
    [press("k", { altKey: true }), "none", null],
    [press("q"), "none", null],
  ] as [KeyPress, Focus, object | null][])("%o with the focus on %s", (key, focus, command) => {
    expect(commandOf(key, focus)).toEqual(command);
  });
});

describe("nextKey", () => {
  const moments = [0, 0.25, 0.75];
  it("goes round where it loops, and stays at the end where it does not", () => {
    expect(nextKey(moments, 0.25, 1, true)).toBe(0.75);
    expect(nextKey(moments, 0.3, -1, true)).toBe(0.25);
    expect(nextKey(moments, 0.75, 1, true)).toBe(0);
    expect(nextKey(moments, 0.8, 1, false)).toBe(0.8);
    expect(nextKey(moments, 0, -1, true)).toBe(0.75);
    expect(nextKey([], 0.4, 1, true)).toBe(0.4);
  });
});
