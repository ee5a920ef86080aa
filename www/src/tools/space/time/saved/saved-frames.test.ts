import { describe, expect, it } from "vitest";
import type { MapRow3, Space, SpaceFrame, SpaceLight, SpaceView } from "#wasm/api";
import { frameRecord, framesText } from "#workers/space/frames";
import { readSaved, type SavedFrames } from "./saved";
import { keysOf, madeOf } from "./saved-frames";

const view: SpaceView = { target: [1, 2, 3], distance: 4, turn: 0.1, tilt: 0.2, angle: 0.9 };
const half = (x: number): MapRow3 => [0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5, x, 0, 0];
const space = { objects: [{ name: "A" }, { name: "B" }] } as unknown as Space;
/** The first moves, the second stays. */
const film = {
  at: (time: number): SpaceFrame => ({
    objects: [half(time), half(7)].map((row) => ({ maps: [row], moved: half(0), now: [row] })),
    view: { ...view, turn: time },
  }),
};
const head = { packed: "word", at: 1, view, loop: "round" as const, fps: 2, seconds: 1.5 };
const texts = [0, 0.5, 1].map((time) => JSON.stringify(frameRecord(space, time, film.at(time), view)));
const text = framesText(head, texts);

function read(from: string): SavedFrames {
  const found = readSaved(from);
  if (!("frames" in found)) throw new Error(JSON.stringify(found));
  return found;
}

describe("frames that were saved", () => {
  it("are read with what they were made of, and known to be still that", () => {
    const found = read(text);
    expect(found.kept).toEqual({ packed: "word", at: 1, view });
    expect([found.loop, found.fps, found.seconds, found.frames.length]).toEqual(["round", 2, 1.5, 3]);
    expect(found.frames.map((frame) => JSON.stringify(frame))).toEqual(texts);
    expect(madeOf(found, space, film, view)).toBe(true);
  });

  it("are known to be changed", () => {
    const [first] = texts;
    for (const [from, to] of [
      ['"turn":0.5', '"turn":0.6'],
      ["0.5,7,0,0", "0.5,8,0,0"],
      ['"B"', '"C"'],
    ] as const) {
      expect(text).toContain(from);
      expect(madeOf(read(text.replace(from, to)), space, film, view)).toBe(false);
    }
    // Another program may write the last digit otherwise.
    expect(madeOf(read(text.replace('"turn":0.5', '"turn":0.50000000000001')), space, film, view)).toBe(true);
    expect(first).toContain('"time":0');
  });

  it("become a key each", () => {
    const made = keysOf(read(text), { light: {} as SpaceLight });
    if ("problem" in made) throw new Error(made.problem);
    const { objects, timeline } = made.space;
    expect(objects).toEqual([
      { name: "A", maps: [half(0)] },
      { name: "B", maps: [half(7)] },
    ]);
    expect(timeline).toMatchObject({ seconds: 1.5, loop: "round", course: "straight" });
    expect(timeline?.keys.map(({ at, maps }) => [at, maps])).toEqual(
      [0, 0.5, 1].map((at) => [at, [[half(at)], null]]),
    );
    for (const [i, key] of (timeline?.keys ?? []).entries()) {
      expect(key.view?.turn).toBe([0, 0.5, 1][i]);
      expect(key.view?.distance).toBeCloseTo(4, 12);
    }
  });

  it("of another program begin at 0, and may have no times", () => {
    const { frames } = JSON.parse(text) as { frames: Record<string, unknown>[] };
    const timeless = frames.map(({ time: _, ...frame }) => frame);
    const made = keysOf(read(JSON.stringify({ fps: 4, frames: timeless })), { light: {} as SpaceLight });
    const late = frames.map((frame, i) => ({ ...frame, time: 5 + i }));
    const other = keysOf(read(JSON.stringify({ frames: late })), { light: {} as SpaceLight });
    const times = [made, other].map((all) => ("space" in all ? all.space.timeline : null));
    expect(times.map((line) => line?.keys.map(({ at }) => at))).toEqual([
      [0, 0.25, 0.5],
      [0, 1, 2],
    ]);
    expect(times.map((line) => [line?.seconds, line?.loop])).toEqual([
      [0.5, "once"],
      [2, "once"],
    ]);
  });
});

describe("bad frames", () => {
  const problem = (change: (file: { frames: unknown[] }) => void) => {
    const file = JSON.parse(text) as { frames: unknown[] };
    change(file);
    const found = readSaved(JSON.stringify(file));
    return "problem" in found ? found.problem : "";
  };
  const second = (change: object) => (file: { frames: unknown[] }) => {
    file.frames[1] = { ...(file.frames[1] as object), ...change };
  };

  it("are named, with what is wrong with them", () => {
    expect(problem(second({ time: -1 }))).toMatch(/^Frame 2 .* time/);
    expect(problem(second({ time: 0 }))).toMatch(/^Frame 2 .* not later/);
    expect(problem(second({ objects: [] }))).toMatch(/^Frame 2 .* 1 to 60 objects/);
    expect(problem(second({ objects: [{ name: "A", maps: [half(0)] }] }))).toMatch(/^Frame 2 .* 1 objects/);
    expect(problem(second({ objects: [{ maps: [[1, 2]] }, { maps: [half(0)] }] }))).toContain("12 numbers");
    expect(problem(second({ view: null }))).toMatch(/^Frame 2 .* seen from/);
    expect(problem(second({ view: { ...view, eye: [1, 2, 3] } }))).toMatch(/^Frame 2 .* seen from/);
    expect(problem((file) => file.frames.splice(0, 3, 1, 2, 3))).toMatch(/^Frame 1 /);
    expect(problem((file) => file.frames.push(...new Array(3600).fill(0)))).toContain("3603 frames");
    expect(problem(() => {})).toBe("");
  });

  it("that are too many for keys are told", () => {
    const { frames } = read(text);
    const [first] = frames;
    const many = Array.from({ length: 101 }, (_, time) => ({
      ...(first as NonNullable<typeof first>),
      time,
    }));
    const made = keysOf({ frames: many, loop: "once", fps: 1, seconds: 0 }, { light: {} as SpaceLight });
    expect("problem" in made ? made.problem : "").toContain("101 frames");
  });
});
