import { describe, expect, it } from "vitest";
import { cameraWords, planeView, solidView } from "./camera";

describe("the view of a file", () => {
  it("is taken in the plane where it is upright", () => {
    expect(planeView({ centre: [1, 2], radius: 3, angle: 360 })).toEqual({ x: 1, y: 2, radius: 3 });
    expect(planeView({ centre: [1, 2], radius: 3, angle: 45 })).toBeNull();
    const plain = { name: "", remarks: [], dimension: 2 as const, maps: [] };
    expect(cameraWords({ ...plain, camera: { centre: [0, 0], radius: 1, angle: 9 } })).toHaveLength(1);
    expect(cameraWords({ ...plain, camera: { centre: [0, 0], radius: 1, angle: 0 } })).toEqual([]);
    expect(cameraWords({ name: "", remarks: [], dimension: 2, maps: [] })).toEqual([]);
  });

  it("is taken in space where z is upwards in it", () => {
    // From (3, -4, 0) to the origin: y lies ahead at no turn, and turning goes counter-clockwise seen from above.
    const front = solidView({ eye: [0, -5, 0], target: [0, 0, 0], up: [0, 0, 1], field: 90 });
    expect(front).toEqual({ target: [0, 0, 0], distance: 5, turn: 0, tilt: 0, angle: Math.PI / 2 });
    const side = solidView({ eye: [5, 0, 5], target: [0, 0, 0], up: [-1, 0, 1], field: 30 });
    expect(side?.turn).toBeCloseTo(Math.PI / 2, 12);
    expect(side?.tilt).toBeCloseTo(Math.PI / 4, 12);
    expect(solidView({ eye: [0, -5, 0], target: [0, 0, 0], up: [1, 0, 1], field: 90 })).toBeNull();
    const above = solidView({ eye: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], field: 30 });
    expect(above?.turn).toBeCloseTo(0, 12);
    expect(above?.tilt).toBeCloseTo(Math.PI / 2, 12);
    expect(solidView({ eye: [0, 0, 0], target: [0, 0, 0], up: [0, 0, 1], field: 30 })).toBeNull();
  });
});
