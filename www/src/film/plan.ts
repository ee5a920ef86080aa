/** What is to be exported: which moments, how large, and how much that will be. Pure, for the tests. */

import { formatNumber } from "#format/numbers";
import { type Easing, heldFrames, MOST_HOLD, momentsOf } from "#geometry/pace";
import type { Repeat } from "#wasm/api";
import { MOST_GIF_FPS } from "#workers/film/format/gif";
import type { FilmKind } from "#workers/film/format/sink";
import { type Samples, sampling } from "#workers/film/subject";
import * as messages from "./messages";

/** Every frame as numbers, or what they are made from. */
export type NumbersKind = "frames" | "keys";
export type Kind = FilmKind | NumbersKind;
export type Quality = "small" | "good" | "best";

export interface Plan {
  kind: Kind;
  width: number;
  height: number;
  fps: number;
  /** Seconds. */
  from: number;
  to: number;
  /** How it goes from one end to the other. */
  easing: Easing;
  /** Seconds that it stands still at each end. */
  hold: number;
  quality: Quality;
  /** For each pixel: the more, the smoother are edges. */
  samples: Samples;
  /** Of a video: whether each pixel has a colour of its own, and not four pixels one. */
  fullColour: boolean;
  /** "#rrggbb"; null: as on the stage. */
  ground: string | null;
  /** Whether what is clear stays clear, where the kind of file can. */
  clear: boolean;
  /** Of a GIF: colours in between as dots of others; null: where that looks better. */
  dither: boolean | null;
  /** Whether photographs lie in it, where there are some. */
  photograph: boolean;
  /** Whether each frame says its moment. */
  captions: boolean;
  /** Whether each frame shows where on the map it is. */
  inset: boolean;
}

export const MOST_FRAMES = 3600;
/** Of one film, once through. */
export const MOST_SECONDS = 120;
export const LEAST_SIDE = 16;
export const MOST_SIDE = 4096;
export const LEAST_FPS = 1;
const MOST_FPS = 60;

/** The most frames a second that a kind of file can show. */
export const mostFps = (kind: Kind): number => (kind === "gif" ? MOST_GIF_FPS : MOST_FPS);
export const isFilm = (kind: Kind): kind is FilmKind => kind !== "frames" && kind !== "keys";
export const isVideo = (kind: Kind): kind is "mp4" | "webm" => kind === "mp4" || kind === "webm";
/** Whether a kind of file can be clear where nothing is. */
export const canBeClear = (kind: Kind): boolean => kind !== "mp4";
/** Codecs halve the sides for colours. */
export const even = (side: number): number => 2 * Math.round(side / 2);

type Part = Pick<Plan, "from" | "to" | "fps"> & Partial<Pick<Plan, "easing" | "hold">>;

/** How many seconds of it move: there and back where it goes to and fro. */
const movingSeconds = ({ from, to }: Pick<Plan, "from" | "to">, loop: Repeat): number =>
  (loop === "pingpong" ? 2 : 1) * (to - from);

/** How many frames of it move: as many a second as were asked for. */
const movingCount = (plan: Part, loop: Repeat): number =>
  Math.max(1, Math.round(movingSeconds(plan, loop) * plan.fps));

const heldOf = ({ hold = 0, fps }: Part, loop: Repeat): number => heldFrames(hold, fps, loop);

/** How many seconds a film of it has. */
export const filmSeconds = (plan: Part, loop: Repeat): number =>
  movingSeconds(plan, loop) + (2 * heldOf(plan, loop)) / plan.fps;

/** How many frames it has. */
export const frameCount = (plan: Part, loop: Repeat): number =>
  movingCount(plan, loop) + 2 * heldOf(plan, loop);

/** The moments of its frames, in seconds. */
export function timesOf(plan: Part, loop: Repeat): number[] {
  const pace = { easing: plan.easing ?? "linear", held: heldOf(plan, loop) };
  return momentsOf(plan, movingCount(plan, loop), loop, pace);
}

/** Why it cannot be made, in words that say what to do; null where it can. */
export function planProblem(plan: Plan, loop: Repeat): string | null {
  const { kind, width, height, fps, from, to } = plan;
  if (kind === "keys") return null;
  if (![fps, from, to].every(Number.isFinite) || !(to > from)) {
    return messages.filmEndsBeforeBegins;
  }
  if (fps < LEAST_FPS || fps > mostFps(kind)) {
    return kind === "gif" && fps <= MOST_FPS
      ? messages.gifFps(MOST_GIF_FPS)
      : messages.chooseFps(LEAST_FPS, mostFps(kind));
  }
  if (!(plan.hold >= 0 && plan.hold <= MOST_HOLD)) {
    return messages.chooseHold(MOST_HOLD);
  }
  const count = frameCount(plan, loop);
  if (count > MOST_FRAMES) {
    const moving = MOST_FRAMES - 2 * heldOf(plan, loop);
    const seconds = Math.floor(moving / fps / (loop === "pingpong" ? 2 : 1));
    return messages.tooManyFrames(grouped(count), grouped(MOST_FRAMES), seconds);
  }
  if (!isFilm(kind)) return null;
  for (const side of [width, height]) {
    if (!(side >= LEAST_SIDE && side <= MOST_SIDE && side % 2 === 0)) {
      return messages.evenSides(LEAST_SIDE, grouped(MOST_SIDE));
    }
  }
  if (sampling(plan.samples).drawn ** 2 * width * height > MOST_SIDE ** 2) {
    return messages.thisSizeTooLarge;
  }
  if (filmBytes(plan, loop) > MOST_BYTES) {
    return messages.tooLarge(bytesWords(filmBytes(plan, loop)));
  }
  return null;
}

/** A file is made in the memory of the page. */
const MOST_BYTES = 1.5e9;
/** Bytes of a PNG for each pixel that shows something. */
const PNG_BYTES = 1.2;

/** Bits for each pixel of a frame: fractals are rough, and need many. */
const BITS: Record<Quality, number> = { small: 0.08, good: 0.2, best: 0.5 };

/** So many times the bits where each pixel has a colour of its own. */
const FULL_COLOUR = 1.3;

/** Bits a second of a video. */
export function bitrateOf({
  width,
  height,
  fps,
  quality,
  fullColour = false,
}: Pick<Plan, "width" | "height" | "fps" | "quality"> & Partial<Pick<Plan, "fullColour">>): number {
  const bits = BITS[quality] * (fullColour ? FULL_COLOUR : 1);
  return Math.round(Math.min(120e6, Math.max(300e3, width * height * fps * bits)));
}

/** The part of all pixels that is neither clear nor the ground. */
export function litPart(pixels: Uint8ClampedArray, ground: readonly number[]): number {
  let lit = 0;
  for (let at = 0; at < pixels.length; at += 4) {
    if ((pixels[at + 3] ?? 0) > 0 && ground.some((channel, k) => pixels[at + k] !== channel)) lit++;
  }
  return pixels.length > 0 ? lit / (pixels.length / 4) : 0;
}

/** Bytes of a GIF for each pixel that shows something, while it moves; the ground hardly takes any. */
const GIF_BYTES = 0.6;

/**
 * About how many bytes a film has; `lit` is the part of a frame that shows something. What a GIF takes depends on what
 * moves.
 */
export function filmBytes(plan: Plan, loop: Repeat, lit = 0.5): number {
  const count = frameCount(plan, loop);
  // What stands still takes no room in a moving picture.
  const moving = movingCount(plan, loop);
  const { width, height } = plan;
  if (plan.kind === "apng" || plan.kind === "zip") {
    return 300 + (PNG_BYTES * lit + 0.01) * width * height * (plan.kind === "zip" ? count : moving);
  }
  if (plan.kind === "gif") return 800 + (GIF_BYTES * lit + 0.003) * width * height * moving;
  return (bitrateOf(plan) / 8) * (count / plan.fps) + 2000;
}

export function bytesWords(bytes: number): string {
  if (bytes < 1000) return `${Math.round(bytes)} bytes`;
  if (bytes < 1e6) return `${formatNumber(bytes / 1000, bytes < 1e4 ? 1 : 0)} kB`;
  if (bytes < 1e9) return `${formatNumber(bytes / 1e6, bytes < 1e7 ? 1 : 0)} MB`;
  return `${formatNumber(bytes / 1e9, bytes < 1e10 ? 1 : 0)} GB`;
}

/** About how long, as one says it. */
export function timeWords(seconds: number): string {
  if (!Number.isFinite(seconds)) return "";
  if (seconds < 2) return messages.moment;
  if (seconds < 55) return `${seconds < 10 ? Math.ceil(seconds) : 5 * Math.ceil(seconds / 5)} s`;
  if (seconds < 3300) return `${Math.max(1, Math.round(seconds / 60))} min`;
  return `${formatNumber(seconds / 3600, 1)} h`;
}

export const grouped = (count: number): string => String(count).replace(/\B(?=(\d{3})+$)/g, ",");

/** Seconds left, after so many frames of all; null until that can be told. */
export function secondsLeft(done: number, of: number, elapsed: number): number | null {
  if (done < 2 || elapsed <= 0) return null;
  return (elapsed / done) * (of - done);
}

const ENDINGS: Partial<Record<Kind, string>> = {
  apng: ".png",
  zip: ".zip",
  frames: "-frames.json",
  keys: ".json",
};

/** Where it is kept under. */
export function fileName(name: string, { kind }: Pick<Plan, "kind">): string {
  return `frond-${name}${ENDINGS[kind] ?? `.${kind}`}`;
}
