/** The parameters of every frame, read from a file: what they were made of, or else keys that say the same. */

import type { MapRow3, Repeat, Space, SpaceFrame, SpaceKey, SpaceView } from "#wasm/api";
import { type FrameRecord, frameRecord } from "#workers/space/frames";
import * as messages from "../messages";
import { MOST_KEYS, SHORTEST } from "../time-edits";

/** The parameters of every frame, as a file has them. */
export interface FramesRead {
  loop: Repeat;
  fps: number;
  seconds: number;
  frames: FrameRecord[];
}

/** As many as the export makes. */
const MOST_FRAMES = 3600;
const MOST_OBJECTS = 60;
/** Two programs round alike, but not to the last bit. */
const SAME = 1e-9;

type Item = Record<string, unknown>;
const itemOf = (value: unknown): Item => (typeof value === "object" && value !== null ? (value as Item) : {});
const isNumber = (x: unknown): x is number => typeof x === "number" && Number.isFinite(x);
const isRow = (row: unknown): row is MapRow3 =>
  Array.isArray(row) && row.length === 12 && row.every(isNumber);

/** The frames of a file, or what is wrong with the first that is none. */
export function readFrames(record: Item, list: readonly unknown[]): FramesRead | { problem: string } {
  if (list.length === 0) return { problem: messages.thisFileContainsNo };
  if (list.length > MOST_FRAMES) {
    return { problem: messages.tooManyFrames(list.length, MOST_FRAMES) };
  }
  const fps = isNumber(record["fps"]) && record["fps"] > 0 ? record["fps"] : 30;
  const frames: FrameRecord[] = [];
  for (const [i, value] of list.entries()) {
    const frame = readFrame(itemOf(value), i / fps);
    if (typeof frame === "string") return { problem: messages.frameProblem(i + 1, frame) };
    const before = frames.at(-1);
    if (before && !(frame.time > before.time)) {
      return { problem: messages.frameNotLater(i + 1) };
    }
    if (before && before.objects.length !== frame.objects.length) {
      return {
        problem: messages.frameObjects(i + 1, frame.objects.length, before.objects.length),
      };
    }
    frames.push(frame);
  }
  const written = record["loop"];
  const loop: Repeat = written === "round" || written === "pingpong" ? written : "once";
  const seconds = isNumber(record["seconds"]) && record["seconds"] > 0 ? record["seconds"] : 0;
  return { loop, fps, seconds, frames };
}

/** A frame, or what is wrong with it. */
function readFrame(item: Item, time: number): FrameRecord | string {
  const at = item["time"] ?? time;
  if (!isNumber(at) || at < 0) return messages.hasTimeNotNumber;
  const objects = item["objects"];
  if (!Array.isArray(objects) || objects.length === 0 || objects.length > MOST_OBJECTS) {
    return messages.needsObjects(MOST_OBJECTS);
  }
  const read: FrameRecord["objects"] = [];
  for (const [k, value] of objects.entries()) {
    const { name, maps } = itemOf(value);
    if (!Array.isArray(maps) || maps.length === 0 || !maps.every(isRow)) {
      return messages.needsParameters(k + 1);
    }
    read.push({ name: typeof name === "string" && name !== "" ? name : messages.objectOf(k + 1), maps });
  }
  const { eye, ...rest } = itemOf(item["view"]);
  const view = viewIn({ ...rest, distance: distanceTo(rest["target"], eye) });
  if (!view) return messages.doesNotSayWhere;
  const { target, turn, tilt, angle } = view;
  return {
    time: at,
    view: { eye: eye as FrameRecord["view"]["eye"], target, turn, tilt, angle },
    objects: read,
  };
}

function distanceTo(target: unknown, eye: unknown): number {
  const three = (x: unknown): x is number[] => Array.isArray(x) && x.length === 3 && x.every(isNumber);
  if (!three(target) || !three(eye)) return Number.NaN;
  return Math.hypot(...target.map((x, k) => x - (eye[k] ?? 0)));
}

/** Whether frames are what a space has at their times: nobody changed them. */
export function madeOf(
  { frames }: Pick<FramesRead, "frames">,
  space: Pick<Space, "objects">,
  film: { at(time: number): SpaceFrame },
  fallback: SpaceView,
): boolean {
  return frames.every((frame) => alike(frameRecord(space, frame.time, film.at(frame.time), fallback), frame));
}

function alike(a: unknown, b: unknown): boolean {
  if (isNumber(a) && isNumber(b)) return Math.abs(a - b) <= SAME * (1 + Math.abs(a));
  if (Array.isArray(a) && Array.isArray(b))
    return a.length === b.length && a.every((item, i) => alike(item, b[i]));
  if (typeof a === "object" && typeof b === "object" && a && b) {
    const [left, right] = [a as Item, b as Item];
    return Object.keys(left).every((name) => alike(left[name], right[name]));
  }
  return a === b;
}

/** A space with a key for each frame, straight from one to the next; or why there cannot be one. */
export function keysOf(
  { frames, loop, seconds }: FramesRead,
  { light, background }: Pick<Space, "light" | "background">,
): { space: Space } | { problem: string } {
  const [first] = frames;
  if (!first) return { problem: messages.thisFileContainsNo };
  if (frames.length > MOST_KEYS) {
    return {
      problem: messages.tooManyKeys(frames.length, MOST_KEYS),
    };
  }
  const moves = first.objects.map(({ maps }, k) =>
    frames.some((frame) => JSON.stringify(frame.objects[k]?.maps) !== JSON.stringify(maps)),
  );
  const keys = frames.map(({ time, view, objects }): SpaceKey => {
    const { eye, target, turn, tilt, angle } = view;
    const key: SpaceKey = {
      at: time - first.time,
      ease: "even",
      view: { target, distance: distanceTo(target, eye), turn, tilt, angle },
    };
    if (moves.includes(true)) key.maps = objects.map(({ maps }, k) => (moves[k] ? maps : null));
    return key;
  });
  const length = Math.max(SHORTEST, keys.at(-1)?.at ?? 0, seconds);
  return {
    space: {
      objects: first.objects.map(({ name, maps }) => ({ name, maps })),
      light,
      ...(background === undefined ? {} : { background }),
      timeline: { seconds: length, loop, course: "straight", keys },
    },
  };
}

/** A view that can be looked from, or nothing. */
export function viewIn(value: unknown): SpaceView | null {
  if (typeof value !== "object" || value === null) return null;
  const { target, distance, turn, tilt, angle, holds } = value as Record<string, unknown>;
  const number = (x: unknown): x is number =>
    typeof x === "number" && Number.isFinite(x) && Math.abs(x) < 1e9;
  if (!Array.isArray(target) || target.length !== 3 || !target.every(number)) return null;
  if (!number(distance) || distance <= 0 || !number(turn) || !number(tilt)) return null;
  if (!number(angle) || angle <= 0 || angle >= Math.PI) return null;
  const [x, y, z] = target as [number, number, number];
  const view: SpaceView = { target: [x, y, z], distance, turn, tilt, angle };
  return holds === "eye" ? { ...view, holds } : view;
}
