import { beforeEach, describe, expect, it } from "vitest";
import type { Scene } from "#wasm/api";
import { LONGEST } from "./history";
import {
  canRedo,
  canUndo,
  edit,
  endGesture,
  inGesture,
  redo,
  replace,
  scene,
  start,
  takeBack,
  undo,
} from "./scene";

const first: Scene = { ...scene.peek() };
const turn = (turns: number[]) => (before: Scene) => ({ ...before, turns });

beforeEach(() => start(first));

describe("edit", () => {
  it("is one step each without a gesture", () => {
    edit(turn([1]));
    edit(turn([2]));
    undo();
    expect(scene.value.turns).toEqual([1]);
    undo();
    expect(scene.value).toEqual(first);
    expect(canUndo.value).toBe(false);
  });

  it("is one step for a whole drag", () => {
    for (let i = 1; i <= 40; i++) edit(turn([i]), { gesture: "drag" });
    expect(inGesture.value).toBe(true);
    endGesture();
    expect(inGesture.value).toBe(false);
    undo();
    expect(scene.value.turns).toEqual([]);
    redo();
    expect(scene.value.turns).toEqual([40]);
  });

  it("begins a new step when the gesture has ended, even under the same name", () => {
    edit(turn([1]), { gesture: "drag" });
    endGesture();
    edit(turn([2]), { gesture: "drag" });
    undo();
    expect(scene.value.turns).toEqual([1]);
  });

  it("begins a new step when another gesture comes in between", () => {
    edit(turn([1]), { gesture: "p" });
    edit(turn([2]), { gesture: "q" });
    edit(turn([3]), { gesture: "p" });
    undo();
    expect(scene.value.turns).toEqual([2]);
  });

  it("leaves the tool to whoever looks", () => {
    replace({ ...scene.peek(), tool: "deform" });
    edit(turn([1]));
    replace({ ...scene.peek(), tool: "fit" });
    undo();
    expect(scene.value).toMatchObject({ tool: "fit", turns: [] });
  });

  it("takes a gesture back that is given up, and no step before it", () => {
    edit(turn([1]), { gesture: "drag" });
    endGesture();
    takeBack();
    expect(scene.value.turns).toEqual([1]);
    edit(turn([2]), { gesture: "drag" });
    edit(turn([3]), { gesture: "drag" });
    takeBack();
    expect([scene.value.turns, canRedo.value, inGesture.value]).toEqual([[1], false, false]);
    undo();
    expect(canUndo.value).toBe(false);
  });

  it("does nothing when nothing changes", () => {
    edit((before) => before);
    expect(canUndo.value).toBe(false);
  });

  it("forgets what was undone", () => {
    edit(turn([1]));
    undo();
    edit(turn([2]));
    expect(canRedo.value).toBe(false);
  });

  it("keeps a bounded past", () => {
    for (let i = 1; i <= LONGEST + 50; i++) edit(turn([i]));
    let steps = 0;
    while (canUndo.value) {
      undo();
      steps++;
    }
    expect(steps).toBe(LONGEST);
    expect(scene.value.turns).toEqual([50]);
  });
});

describe("undo and the moment", () => {
  it("leaves the time and the view to whoever looks", () => {
    edit(turn([1]));
    replace({ ...scene.value, t: 0.75, view: { x: 1, y: 2, zoom: 3 } });
    undo();
    expect(scene.value.turns).toEqual([]);
    expect(scene.value.t).toBe(0.75);
    expect(scene.value.view).toEqual({ x: 1, y: 2, zoom: 3 });
  });

  it("takes the time back where the step itself set it", () => {
    edit((before) => ({ ...before, t: 0.5, turns: [1] }));
    replace({ ...scene.value, t: 0.9 });
    undo();
    expect(scene.value.t).toBe(first.t);
    redo();
    expect(scene.value.t).toBe(0.5);
  });

  it("does nothing at either end", () => {
    undo();
    redo();
    expect(scene.value).toEqual(first);
  });
});
