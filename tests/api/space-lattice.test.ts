/** A lattice around a shape of space that moves along the time line. */
import { readFile } from "node:fs/promises";
import { beforeAll, beforeEach, expect, it, vi } from "vitest";
import * as frond from "../../www/pkg/frond-space.js";
import { scene, start, undo } from "../../www/src/document/scene";
import { addKey, endTimeline, startWith } from "../../www/src/document/space/edits";
import {
  editSpace,
  openSpace,
  setMoment,
  space,
  spaceFrame,
  timeline,
} from "../../www/src/document/space/space";
import { atRest, withMoved } from "../../www/src/tools/space/bend/bend-edits";
import { bendObject, bentNow } from "../../www/src/tools/space/bend/now";
import { withoutObject } from "../../www/src/tools/space/shape/object-edits";
import { keyWords } from "../../www/src/tools/space/time/time-text";
import type { SpaceBend } from "../../www/src/wasm/api";
import { shownObject } from "../../www/src/workers/space/shown";

// Here it is started from a file.
vi.mock("../../www/src/wasm/space", async () => ({
  solid: await import("../../www/pkg/frond-space.js"),
  loadSpace: async () => {},
  compileSpace: async () => undefined,
}));

const blank = { ...scene.peek() };

beforeAll(async () => {
  const module = await readFile(new URL("../../www/pkg/frond-space_bg.wasm", import.meta.url));
  await frond.default({ module_or_path: module });
  await openSpace();
});

const bend = (): SpaceBend => {
  const now = bentNow(0);
  if (!now) throw new Error("nothing is bent");
  return now;
};
const lifted = () => bend().moves.at(-1)?.[2];

beforeEach(() => {
  start({ ...blank });
  startWith(frond.defaultSpace().objects);
  bendObject(0, atRest([2, 2, 2], 3));
});

it("without a time line the lattice is the object's", () => {
  bendObject(0, withMoved(bend(), 7, [0, 0, 0.5]));
  expect(space.value?.objects[0]?.bend?.moves[7]).toEqual([0, 0, 0.5]);
  expect(timeline.value).toBeNull();
});

it("goes from one key to another, and is drawn as it is at the moment", () => {
  addKey();
  expect(timeline.value?.keys[0]?.bends?.[0]?.[7]).toEqual([0, 0, 0]);
  setMoment(4);
  bendObject(0, withMoved(bend(), 7, [0, 0, 0.5]), { gesture: "pull" });
  bendObject(0, withMoved(bend(), 7, [0, 0, 0.3]), { gesture: "pull" });
  expect(timeline.value?.keys).toHaveLength(2);
  expect(lifted()).toBe(0.8);
  // What the object says is as it was: the keys say where its lattice is.
  expect(space.value?.objects[0]?.bend?.moves[7]).toEqual([0, 0, 0]);
  setMoment(2);
  const between = lifted() ?? 0;
  expect(between).toBeGreaterThan(0.1);
  expect(between).toBeLessThan(0.7);
  const [now] = spaceFrame.value?.objects ?? [];
  if (!now) throw new Error("there is no frame");
  expect(shownObject(now, space.value?.objects[0]).bent?.bend.moves[7]?.[2]).toBe(between);
  expect(keyWords(timeline.value?.keys[1] ?? { at: 0, ease: "even" })).toBe("one object");
  // It goes through the link.
  const packed = scene.value.space?.packed ?? "";
  expect(frond.unpackSpace(packed)).toEqual(space.value);
  undo();
  expect(timeline.value?.keys).toHaveLength(1);
});

it("a first key in a film says of the others what was", () => {
  addKey();
  // As documents of before have it: keys that say nothing of lattices.
  editSpace((now) => {
    const line = now.timeline;
    if (!line) return now;
    return { ...now, timeline: { ...line, keys: line.keys.map(({ bends: _, ...key }) => key) } };
  });
  expect(spaceFrame.value?.objects[0]?.bend).toBeUndefined();
  setMoment(3);
  bendObject(0, withMoved(bend(), 7, [0, 0, 1]));
  setMoment(0);
  expect(lifted()).toBe(0);
});

it("what is no place of a handle holds for all time, and another lattice keeps its shape in every key", () => {
  addKey();
  setMoment(3);
  bendObject(0, withMoved(bend(), 7, [0, 0, 0.8]));
  bendObject(0, { ...bend(), delta: 1.25 });
  expect(space.value?.objects[0]?.bend).toMatchObject({ delta: 1.25, moves: atRest([2, 2, 2], 3).moves });
  expect(timeline.value?.keys).toHaveLength(2);
  bendObject(0, { ...bend(), ...atRest([3, 3, 3], 3), delta: 1.25 });
  expect(timeline.value?.keys.map((key) => key.bends?.[0]?.length)).toEqual([27, 27]);
  expect(bend().moves).toHaveLength(27);
  expect(lifted()).toBeCloseTo(0.8, 9);
});

it("goes with its object and with the time line", () => {
  addKey();
  setMoment(3);
  bendObject(0, withMoved(bend(), 7, [0, 0, 0.8]));
  endTimeline();
  expect(space.value?.objects[0]?.bend?.moves[7]?.[2]).toBeCloseTo(0.8, 9);
  undo();
  editSpace((now) => ({ ...now, objects: [...now.objects, ...frond.defaultSpace().objects] }));
  editSpace((now) => withoutObject(now, 0));
  expect(timeline.value?.keys.every((key) => !key.bends?.some((moves) => moves !== null))).toBe(true);
  undo();
  bendObject(0, null);
  expect(space.value?.objects[0]?.bend).toBeUndefined();
  expect(timeline.value?.keys.every((key) => key.bends === undefined)).toBe(true);
});
