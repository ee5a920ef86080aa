import { describe, expect, it, vi } from "vitest";

vi.mock("#wasm/core", () => ({ frond: {} }));
const { commandOf, nextFrame, SHORTCUTS } = await import("./shortcuts");

const press = (
  key: string,
  held: Partial<Record<"shiftKey" | "ctrlKey" | "metaKey" | "altKey", boolean>> = {},
) => ({
  key,
  shiftKey: false,
  ctrlKey: false,
  metaKey: false,
  altKey: false,
  ...held,
});

describe("commandOf", () => {
  it("leaves every key to those who type", () => {
    for (const key of [" ", "z", "ArrowLeft", "?", "1"]) expect(commandOf(press(key), "typing")).toBeNull();
    expect(commandOf(press("z", { ctrlKey: true }), "typing")).toBeNull();
  });
  it("undoes from a field in which nothing typed is waiting, and does no more there", () => {
    expect(commandOf(press("z", { ctrlKey: true }), "field")).toEqual({ do: "undo" });
    for (const key of [" ", "z", "ArrowLeft", "?", "1"]) expect(commandOf(press(key), "field")).toBeNull();
  });
  it("leaves a button its space, and a slider its arrows", () => {
    expect(commandOf(press(" "), "control")).toBeNull();
    expect(commandOf(press("ArrowLeft"), "slider")).toBeNull();
    expect(commandOf(press("ArrowLeft"), "control")).toBeNull();
    expect(commandOf(press(" "), "slider")).toEqual({ do: "play" });
    expect(commandOf(press("ArrowLeft", { shiftKey: true }), "none")).toEqual({ do: "scrub", by: -0.001 });
  });
  it("undoes and redoes by letter and by chord", () => {
    expect(commandOf(press("z"), "none")).toEqual({ do: "undo" });
    expect(commandOf(press("Z", { shiftKey: true }), "none")).toEqual({ do: "redo" });
    expect(commandOf(press("z", { metaKey: true }), "control")).toEqual({ do: "undo" });
    expect(commandOf(press("Z", { ctrlKey: true, shiftKey: true }), "none")).toEqual({ do: "redo" });
    expect(commandOf(press("y", { ctrlKey: true }), "none")).toEqual({ do: "redo" });
  });
  it("never takes a chord of the browser", () => {
    for (const key of ["f", "g", "e", "1", "ArrowLeft", " ", "["]) {
      expect(commandOf(press(key, { ctrlKey: true }), "none")).toBeNull();
      expect(commandOf(press(key, { altKey: true }), "none")).toBeNull();
    }
  });
  it("colours by number", () => {
    expect(commandOf(press("3"), "none")).toEqual({ do: "colour", by: "density" });
  });
});

describe("nextFrame", () => {
  it("goes to the next moment, or to the end", () => {
    expect(nextFrame([0, 0.5, 1], 0.5, 1)).toBe(1);
    expect(nextFrame([0, 0.5, 1], 0.4, -1)).toBe(0);
    expect(nextFrame([0, 0.5, 1], 1, 1)).toBe(1);
    expect(nextFrame([], 0.3, -1)).toBe(0);
  });
});

describe("the list", () => {
  it("names each thing once", () => {
    const does = SHORTCUTS.flatMap((group) => group.rows.map((row) => row.does));
    expect(new Set(does).size).toBe(does.length);
  });
});
