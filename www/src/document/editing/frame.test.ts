import { afterEach, describe, expect, it, vi } from "vitest";
import type { MapRow, Scene } from "#wasm/api";

/** The box of the corners' fixed points: right for maps that only shrink, which is all that these tests have. */
const bounds = ({ maps }: { maps: MapRow[] }) => {
  const xs = maps.map(([a, , , , e]) => e / (1 - a));
  const ys = maps.map(([, , , d, , f]) => f / (1 - d));
  return { min: [Math.min(...xs), Math.min(...ys)], max: [Math.max(...xs), Math.max(...ys)] };
};
vi.mock("#wasm/core", () => ({ frond: { bounds } }));

const { selection } = await import("../morph");
const { edit, endGesture, scene, start, undo } = await import("../scene");
const { carryFrame, editedNow, editFrame, frameAround, frameOf, refitEdited, setFrame } = await import(
  "./frame"
);

const at = (x: number, y: number, s = 0.5): MapRow => [s, 0, 0, s, x, y];
const first = scene.peek();
const opened = (maps: MapRow[], preset?: string) => {
  start({ ...first, a: { name: "One", maps, ...(preset ? { preset } : {}) } });
  selection.value = { target: "a", map: 0 };
};
const moved = (maps: MapRow[], gesture?: string) =>
  edit(
    (before: Scene) => ({ ...before, a: { name: "One", maps: carryFrame(before.a.maps, maps) } }),
    gesture === undefined ? {} : { gesture },
  );

afterEach(() => {
  selection.value = null;
  start(first);
});

describe("the frame of a shape that is edited", () => {
  it("is the box of a shape of the gallery, and stays while maps are moved, taken away and undone", () => {
    opened([at(0, 0), at(1, 0), at(0, 0.75)], "one");
    const frame = editFrame.value;
    expect(frame?.box).toEqual({ x0: 0, y0: 0, x1: 2, y1: 1.5 });
    moved([at(0, 0), at(3, 0), at(0, 0.75)]);
    expect(editFrame.value).toBe(frame);
    moved([at(0, 0)]);
    expect(editFrame.value).toBe(frame);
    undo();
    expect(editFrame.value).toBe(frame);
    // Another frame is no step of undo, and stays over one.
    setFrame(scene.peek().a.maps, { x0: 0, y0: 0, x1: 3, y1: 3 });
    undo();
    expect(editFrame.value?.box.x1).toBe(3);
  });

  it("is the unit square for maps that were made in it", () => {
    opened([at(0, 0), at(0.25, 0.5)]);
    expect(editFrame.value?.box).toEqual({ x0: 0, y0: 0, x1: 1, y1: 1 });
    // A shape of the gallery fills its frame, although its maps lie in the square as well.
    expect(frameOf([at(0, 0), at(0.25, 0.5)], true).box).toEqual({ x0: 0, y0: 0, x1: 0.5, y1: 1 });
    expect(frameOf([at(0, 0), at(0.6, 0)]).box).not.toEqual({ x0: 0, y0: 0, x1: 1, y1: 1 });
  });

  it("has an area although the shape is a point, or lies on a line", () => {
    expect(frameAround([at(1, 1)])).toEqual({ x0: 1.875, y0: 1.875, x1: 2.125, y1: 2.125 });
    const line = frameAround([at(0, 0), at(2, 0)]);
    expect(line).toEqual({ x0: 0, y0: -0.5, x1: 4, y1: 0.5 });
    // Bounds are a little wide, and no number of a frame is long for that.
    expect(frameAround([at(-2e-5, 1 / 3), at(0.50002, 0)])).toEqual({ x0: 0, y0: 0, x1: 1, y1: 0.667 });
  });

  it("follows the shape where that is chosen, but not under a hand", () => {
    opened([at(0, 0), at(1, 0.5)], "one");
    setFrame(scene.peek().a.maps, { x0: 0, y0: 0, x1: 1, y1: 1 }, { follows: true });
    expect(editFrame.value?.box).toEqual({ x0: 0, y0: 0, x1: 2, y1: 1 });
    moved([at(0, 0), at(2, 0.5)], "drag");
    expect(editFrame.value?.box.x1).toBe(2);
    endGesture();
    expect(editFrame.value?.box.x1).toBe(4);
  });

  it("leaves the view as it is until it is asked to fit", () => {
    opened([at(0, 0), at(0.5, 0.5)]);
    const { seen } = editFrame.value ?? {};
    moved([at(0, 0), at(1.5, 0.5)]);
    expect(editFrame.value?.seen).toEqual(seen);
    expect(editedNow.value?.x1).toBe(3);
    refitEdited();
    expect(editFrame.value?.seen.x1).toBe(3);
    setFrame(scene.peek().a.maps, { x0: -9, y0: 0, x1: 1, y1: 1 }, { byHand: true });
    expect(editFrame.value?.seen.x0).toBe(0);
  });
});
