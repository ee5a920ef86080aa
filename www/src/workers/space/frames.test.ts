import { afterEach, describe, expect, it } from "vitest";
import type { MapRow3, Space, SpaceFrame, SpaceView } from "#wasm/api";
import { type SpaceModule, solid } from "#wasm/space";
import { Frames, frameRecord } from "./frames";

const half: MapRow3 = [0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5, 0, 0, 0];
const view: SpaceView = { target: [1, 2, 3], distance: 2, turn: 0, tilt: 0, angle: 0.9 };
const frame: SpaceFrame = { objects: [{ maps: [half], moved: half, now: [half, half] }] };
const space = { objects: [{ name: "Half", maps: [half] }] } as unknown as Space;

afterEach(() => {
  for (const name of Object.keys(solid)) delete (solid as unknown as Record<string, unknown>)[name];
});

describe("a frame as a file has it", () => {
  it("is its parameters now, and where it is seen from", () => {
    expect(frameRecord(space, 1.5, frame, view)).toEqual({
      time: 1.5,
      view: { eye: [1, 0, 3], target: [1, 2, 3], turn: 0, tilt: 0, angle: 0.9 },
      objects: [{ name: "Half", maps: [half, half] }],
    });
    const flown = { ...frame, view: { ...view, distance: 5 } };
    expect(frameRecord(space, 0, flown, view).view.eye).toEqual([1, -3, 3]);
  });
});

describe("frames", () => {
  const film = (at: (seconds: number) => SpaceFrame) => {
    let freed = 0;
    class Motion {
      at = at;
      free() {
        freed++;
      }
    }
    Object.assign(solid, { SpaceMotion: Motion } as unknown as Partial<SpaceModule>);
    return () => freed;
  };

  it("stand still where a moment has none, and count these", () => {
    const freed = film((seconds) => {
      if (seconds > 1) throw new Error("no attractor");
      return { ...frame, t: seconds };
    });
    const frames = new Frames(space);
    expect([0, 1, 2, 3].map((time) => frames.at(time).t)).toEqual([0, 1, 1, 1]);
    expect(frames.missing).toBe(2);
    frames.free();
    expect(freed()).toBe(1);
  });

  it("fail where there is none to begin with", () => {
    film(() => {
      throw new Error("no attractor");
    });
    expect(() => new Frames(space).at(0)).toThrow("no attractor");
  });
});
