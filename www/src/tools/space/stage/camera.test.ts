import { describe, expect, it } from "vitest";
import type { Point3, SpaceView } from "#wasm/api";
import {
  axesOf,
  depthOf,
  eyeOf,
  flown,
  fromOrigin,
  MOST_ANGLE,
  neared,
  panned,
  shiftByHand,
  showsAll,
  sightOf,
  turned,
  turnedByHand,
  wholeView,
  wrapped,
} from "./camera";

const VIEW: SpaceView = { target: [1, 2, 3], distance: 4, turn: 0.7, tilt: 0.3, angle: 0.8 };
const close = (p: Point3, q: Point3) => {
  for (const i of [0, 1, 2] as const) expect(p[i]).toBeCloseTo(q[i], 9);
};

/** Where a point is in a picture of some height, as a pinhole has it: right of and above the middle. */
function seen(view: SpaceView, point: Point3, height: number): [number, number] {
  const eye = eyeOf(view);
  const { right, up, ahead } = axesOf(view);
  const d = point.map((x, i) => x - (eye[i] ?? 0));
  const along = (a: Point3) => a.reduce((sum, x, i) => sum + x * (d[i] ?? 0), 0);
  const focal = height / (2 * Math.tan(view.angle / 2));
  return [(along(right) / along(ahead)) * focal, (along(up) / along(ahead)) * focal];
}

describe("looking around", () => {
  it("looks along y where nothing is turned", () => {
    const straight = { ...VIEW, turn: 0, tilt: 0 };
    close(eyeOf(straight), [1, -2, 3]);
    close(axesOf(straight).right, [1, 0, 0]);
    close(axesOf(straight).ahead, [0, 1, 0]);
    close(axesOf({ ...VIEW, turn: 0, tilt: Math.PI / 2 }).ahead, [0, 0, -1]);
  });

  it("has axes that are square, right-handed and of length one", () => {
    const { right, up, ahead } = axesOf(VIEW);
    const cross: Point3 = [
      right[1] * up[2] - right[2] * up[1],
      right[2] * up[0] - right[0] * up[2],
      right[0] * up[1] - right[1] * up[0],
    ];
    // To the right, up, and towards the eye.
    close(cross, ahead.map((x) => -x) as Point3);
  });

  it("keeps what it holds", () => {
    close(turned(VIEW, 1, -0.4).target, VIEW.target);
    const held: SpaceView = { ...VIEW, holds: "eye" };
    const after = turned(held, 1, -0.4);
    close(eyeOf(after), eyeOf(held));
    expect(after.target).not.toEqual(held.target);
  });

  it("takes what is under the hand along", () => {
    const before = eyeOf(VIEW);
    const { right, up } = axesOf(VIEW);
    // The hand pulls the front of the thing to the right and down: the eye goes left and up.
    const after = eyeOf(turnedByHand(VIEW, 10, 10, 500));
    const way = after.map((x, i) => x - (before[i] ?? 0));
    expect(way.reduce((sum, x, i) => sum + x * (right[i] ?? 0), 0)).toBeLessThan(0);
    expect(way.reduce((sum, x, i) => sum + x * (up[i] ?? 0), 0)).toBeGreaterThan(0);
    const held: SpaceView = { ...VIEW, tilt: 0, holds: "eye" };
    const [x, y] = seen(turnedByHand(held, 10, 6, 500), held.target, 500);
    expect(x).toBeCloseTo(10, 0);
    expect(y).toBeCloseTo(-6, 0);
    const [px, py] = seen(panned(VIEW, 30, 20, 500), VIEW.target, 500);
    expect(px).toBeCloseTo(30, 6);
    expect(py).toBeCloseTo(-20, 6);
  });

  it("nears by distance, or, where the eye stays, by the angle", () => {
    expect(neared(VIEW, 2, null).distance).toBeCloseTo(2, 12);
    const held = neared({ ...VIEW, holds: "eye" }, 2, null);
    expect(held.distance).toBe(VIEW.distance);
    expect(Math.tan(held.angle / 2)).toBeCloseTo(Math.tan(VIEW.angle / 2) / 2, 12);
    expect(neared({ ...VIEW, holds: "eye" }, 1e-9, null).angle).toBe(MOST_ANGLE);
    expect(neared(VIEW, 1e12, { centre: [0, 0, 0], radius: 2 }).distance).toBeGreaterThan(0);
  });

  it("flies with its target", () => {
    const before = eyeOf(VIEW);
    const after = flown(VIEW, 0, 0, 2);
    expect(depthOf(VIEW, eyeOf(after))).toBeCloseTo(2, 9);
    expect(after.distance).toBe(VIEW.distance);
    close(eyeOf(flown(after, 0, 0, -2)), before);
  });

  it("keeps angles within a turn", () => {
    expect(wrapped(3 * Math.PI)).toBeCloseTo(Math.PI, 12);
    expect(wrapped(-0.5)).toBe(-0.5);
  });
});

describe("places to look from", () => {
  const ball = { centre: [3, -4, 12] as Point3, radius: 2 };

  it("has all points in the picture, and is as near as can be", () => {
    const points: Point3[] = [];
    for (let i = 0; i < 60; i++) points.push([3 * Math.sin(i), 8 + 2 * Math.cos(7 * i), Math.sin(3 * i) - 4]);
    for (const aspect of [2, 0.5]) {
      const view = wholeView({ ...VIEW, holds: "eye" }, points, aspect);
      expect(view.holds).toBeUndefined();
      expect([view.turn, view.tilt]).toEqual([VIEW.turn, VIEW.tilt]);
      expect(showsAll(view, points, aspect)).toBe(true);
      // Nearer by more than its margin, something is cut off.
      expect(showsAll(neared(view, 1.3, null), points, aspect)).toBe(false);
      // They lie around what is looked at.
      const depths = points.map((p) => depthOf(view, p));
      expect(Math.min(...depths)).toBeLessThan(view.distance);
      expect(Math.max(...depths)).toBeGreaterThan(view.distance);
    }
  });

  it("comes out of the midst of things, and makes a single point something to look at", () => {
    const points: Point3[] = [
      [1, 0, 0],
      [-1, 0, 0],
      [0, 1, 0],
      [0, -1, 0],
    ];
    const inside: SpaceView = { ...VIEW, target: [0, 0, 0], distance: 1e-3, angle: 2.9 };
    expect(showsAll(inside, points, 1)).toBe(false);
    expect(showsAll(wholeView(inside, points, 1), points, 1)).toBe(true);
    expect(wholeView(VIEW, [[1, 2, 3]], 1).distance).toBeGreaterThan(0);
  });

  it("looks from the origin at the middle of the ball", () => {
    const view = fromOrigin(VIEW, ball);
    close(eyeOf(view), [0, 0, 0]);
    close(view.target, ball.centre);
    expect(view.holds).toBe("eye");
    const within = fromOrigin(VIEW, { centre: [0, 0, 0], radius: 1 });
    close(eyeOf(within), [0, 0, 0]);
    expect(within.turn).toBe(VIEW.turn);
  });

  it("tells what lies behind the eye", () => {
    const eye = { ...VIEW, turn: 0, tilt: 0, target: [0, 4, 0] as Point3 };
    expect(sightOf(eye, { centre: [0, 5, 0], radius: 1 })).toBe("before");
    expect(sightOf(eye, { centre: [0, 0.5, 0], radius: 1 })).toBe("around");
    expect(sightOf(eye, { centre: [0, -3, 0], radius: 1 })).toBe("behind");
  });
});

describe("what hands do to an object", () => {
  it("shifts as far as the hand goes", () => {
    const point: Point3 = [1.5, 2.5, 2];
    const by = shiftByHand(VIEW, 25, -10, depthOf(VIEW, point), 400);
    const [x0, y0] = seen(VIEW, point, 400);
    const [x1, y1] = seen(VIEW, point.map((x, i) => x + (by[i] ?? 0)) as Point3, 400);
    expect(x1 - x0).toBeCloseTo(25, 6);
    expect(y1 - y0).toBeCloseTo(10, 6);
  });
});
