/** What undo leaves of the parts that tools have in the document: each says so in its entry. */
import { beforeEach, describe, expect, it, vi } from "vitest";
import { AT_REST } from "#document/deform/bend";
import { cameFrom, edit, lastStep, redo, replace, scene, start, undo } from "#document/scene";
import type { Scene } from "#wasm/api";
import "./tools";

vi.mock("#wasm/core", () => ({ frond: {} }));

const first: Scene = { ...scene.peek() };

beforeEach(() => start(first));

describe("undo in the deformation", () => {
  it("leaves the moment where it is", () => {
    replace({ ...scene.peek(), tool: "deform", deform: AT_REST });
    edit((before) => ({ ...before, deform: { ...(before.deform ?? AT_REST), kb: 3 } }));
    replace({ ...scene.peek(), tool: "morph", deform: { ...AT_REST, kb: 3, phase: 0.5 } });
    undo();
    expect(scene.value.tool).toBe("morph");
    expect(scene.value.deform).toEqual({ ...AT_REST, kb: 0, phase: 0.5 });
    redo();
    expect(scene.value.deform).toEqual({ ...AT_REST, kb: 3, phase: 0.5 });
  });
});

describe("undo of a file that opened another tool", () => {
  it("goes back to the tool before, and redo to the other", () => {
    replace({ ...scene.peek(), tool: "deform" });
    const before = lastStep();
    replace({ ...scene.peek(), tool: "space" });
    cameFrom("deform", before);
    edit((now) => ({ ...now, space: { packed: "o:tree", at: 0 } }));
    cameFrom("deform", before);
    undo();
    expect(scene.value.tool).toBe("deform");
    redo();
    expect(scene.value.tool).toBe("space");
  });
});

describe("undo in space", () => {
  const view = { target: [0, 0, 0] as [number, number, number], distance: 5, turn: 1, tilt: 0, angle: 1 };

  it("leaves the view and the moment where they are", () => {
    edit((now) => ({ ...now, space: { packed: "o:tree", at: 0 } }));
    replace({ ...scene.peek(), space: { packed: "o:tree", at: 2, view } });
    undo();
    expect(scene.value.space).toEqual({ packed: "", at: 2, view });
    redo();
    expect(scene.value.space).toEqual({ packed: "o:tree", at: 2, view });
  });

  it("brings them back where the step changed them", () => {
    replace({ ...scene.peek(), space: { packed: "o:tree", at: 2, view } });
    edit((now) => ({ ...now, space: { packed: "o:fern", at: 0 } }));
    undo();
    expect(scene.value.space).toEqual({ packed: "o:tree", at: 2, view });
  });
});
