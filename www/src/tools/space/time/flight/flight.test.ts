import { describe, expect, it } from "vitest";
import type { MapRow3, Point3, SpaceTimeline, SpaceView } from "#wasm/api";
import { aroundOf, eyeOf, FLIGHT_SECONDS, lookingFrom, throughOf, withFlight } from "./flight";

const view: SpaceView = { target: [0, 0, 0], distance: 5, turn: 0.4, tilt: 0.3, angle: 0.9 };
const ball = { centre: [0, 0, 0] as Point3, radius: 1 };
const close = (a: Point3, b: Point3) =>
  expect(Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2])).toBeLessThan(1e-9);

describe("a view", () => {
  it("from a point has its eye there, and turn 0 looks along y", () => {
    for (const eye of [
      [3, 1, 2],
      [-1, -4, 0.5],
      [0, 0, 5],
    ] as Point3[]) {
      close(eyeOf(lookingFrom(eye, [0.5, 0.2, -0.3], 1)), eye);
    }
    const north = lookingFrom([0, -2, 0], [0, 0, 0], 1);
    expect(north.turn).toBeCloseTo(0);
    expect(north.distance).toBe(2);
  });
});

describe("a flight", () => {
  it("goes once around, never more than half a turn between keys, and comes back", () => {
    const views = aroundOf(view, ball);
    expect(views).toHaveLength(4);
    const turns = views.map(({ turn }) => turn - view.turn);
    expect(turns.at(-1)).toBeCloseTo(2 * Math.PI);
    for (const [i, turn] of turns.entries())
      if (i > 0) expect(turn - (turns[i - 1] ?? 0)).toBeLessThan(Math.PI);
    const [first, last] = [views[0], views.at(-1)].map((key) => eyeOf(key ?? view)) as [Point3, Point3];
    close(first, last);
    for (const { distance } of views) expect(distance).toBeGreaterThan(ball.radius);
  });

  it("goes into what is around the eye, and starts where the eye is", () => {
    const wide = { centre: [10, 0, 0] as Point3, radius: 12 };
    const start = lookingFrom([0, 0, 0], [10, 0, 0], 1);
    const views = throughOf(start, wide);
    close(eyeOf(views[0] ?? view), [0, 0, 0]);
    const ahead = views.map((key) => eyeOf(key)[0]);
    expect(ahead[1]).toBeGreaterThan(3);
    expect(ahead[2]).toBeGreaterThan(ahead[1] ?? 0);
    // The last looks back on it from above.
    expect(eyeOf(views[3] ?? view)[2]).toBeGreaterThan(1);
  });

  it("stays finite where the eye is in the very middle", () => {
    const inside = lookingFrom([0, 0, 1e-9], [0, 0, 0], 1);
    for (const key of throughOf(inside, ball)) {
      expect([...key.target, key.distance, key.turn, key.tilt].every(Number.isFinite)).toBe(true);
      expect(key.distance).toBeGreaterThan(0);
    }
  });

  it("is a time line of its own, or takes its place on the one there is", () => {
    const views = aroundOf({ ...view, holds: "eye" }, ball);
    const alone = withFlight(null, views);
    expect([alone.seconds, alone.loop, alone.keys.map(({ at }) => at)]).toEqual([
      FLIGHT_SECONDS,
      "once",
      [0, 4, 8, 12],
    ]);
    expect(alone.keys.every((key) => key.view && !("holds" in key.view))).toBe(true);
    const moved: (MapRow3 | null)[] = [[1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]];
    const line: SpaceTimeline = {
      seconds: 6,
      loop: "once",
      course: "straight",
      keys: [
        { at: 0, ease: "hold", moved, view },
        { at: 1, ease: "even", view },
        { at: 5, ease: "even", t: 0.5 },
      ],
    };
    const both = withFlight(line, views);
    expect([both.seconds, both.course]).toEqual([6, "straight"]);
    expect(both.keys.map(({ at }) => at)).toEqual([0, 2, 4, 5, 6]);
    expect(both.keys[0]).toMatchObject({ moved, ease: "hold", view: { turn: view.turn } });
    expect(both.keys[3]).toEqual({ at: 5, ease: "even", t: 0.5 });
  });
});
