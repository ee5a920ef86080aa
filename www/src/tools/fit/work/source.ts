/** What is fitted: a file that was opened, a leaf grown by program, or the curve that a link brought. */

import { computed, type ReadonlySignal, signal } from "@preact/signals";
import type { KeptPhotograph } from "#document/kept/fits";
import { announce, notify, wordsOf } from "#document/notice";
import type { Box } from "#geometry/boxes";
import { boxOfPoints } from "#geometry/point-box";
import type { Curve } from "#wasm/api";
import { fitTask } from "#workers/fit/client";
import type { Grown } from "#workers/fit/curve";
import type {
  Opened,
  OpenedOutlines,
  OpenedPicture,
  OpenedSeries,
  ReadOutline,
} from "#workers/fit/trace-types";
import { isStopped, Latest } from "#workers/lanes/latest";
import * as messages from "../messages";

export type Source =
  | { kind: "grown"; name: string; grown: Grown; seed: number }
  | { kind: "picture"; name: string; picture: OpenedPicture }
  | { kind: "outlines"; name: string; outlines: ReadOutline[]; chosen: number }
  /**
   * The curve of the document is there, with the numbers, or of a word the bytes, that were asked for; of a link no
   * more.
   */
  | {
      kind: "kept";
      name: string;
      curve: Curve;
      word: string | null;
      numbers: number;
      origin: Origin | null;
    };

/** What a fit was made from, where it was kept with it. */
export interface Origin {
  /** x0, y0, x1, y1, .. before it is smoothed. */
  outline: Float64Array;
  /** How much it was smoothed. */
  smoothing: number;
  photograph: KeptPhotograph | null;
}

const FIRST: Source = { kind: "grown", name: messages.mapleLeaf, grown: "sugar-maple", seed: 1 };

const present = signal<Source>(FIRST);
const before = signal<Source | null>(null);

export const source: ReadonlySignal<Source> = present;

/** What was there before: one can go back to it. */
export const former: ReadonlySignal<Source | null> = before;

/** The picture that is worked on, if it is one. */
export const opened: ReadonlySignal<OpenedPicture | null> = computed(() =>
  present.value.kind === "picture" ? present.value.picture : null,
);

/** The name of the file that is being read. */
export const reading = signal<string | null>(null);

const files = new Latest();

/** Pictures live in this worker. */
export const PICTURE_LANE = 1;

/** Takes another source; what was there stays at hand. */
export function takeSource(next: Source): void {
  const last = present.peek();
  if (last === next) return;
  files.stop();
  reading.value = null;
  const dropped = before.peek();
  // Of pictures two are kept: that which is worked on and the one before.
  if (dropped?.kind === "picture" && dropped !== next) close(dropped.picture);
  before.value = last;
  present.value = next;
}

/** A picture takes the place of the one it was made of, which is let go of. */
export function replacePicture(picture: OpenedPicture): void {
  const last = present.peek();
  if (last.kind !== "picture") return;
  present.value = { ...last, picture };
  close(last.picture);
}

/** Back to what was there before. */
export function takeFormer(): void {
  const last = before.peek();
  if (!last) return;
  const now = present.peek();
  before.value = now;
  present.value = last;
  announce(messages.backOnStage(last.name));
}

/** Another of the outlines of a file. */
export function chooseOutline(chosen: number): void {
  const now = present.peek();
  if (now.kind === "outlines" && now.outlines[chosen]) present.value = { ...now, chosen };
}

function close(picture: OpenedPicture): void {
  picture.bitmap.close();
  fitTask("closeFile", { id: picture.id }, { lane: PICTURE_LANE }).catch(() => {});
}

/**
 * Reads a file: a picture, a drawing or numbers. The last one that was given counts; what was there stays until it is
 * read.
 */
export async function takeFile(
  file: Blob,
  given: string,
  takeSeries: (series: OpenedSeries) => void,
): Promise<void> {
  const signal = files.begin();
  const name = given.trim() || messages.outline;
  reading.value = name;
  try {
    const got = await fitTask("openFile", { file, name }, { lane: PICTURE_LANE });
    if (signal.aborted) {
      // Another was given meanwhile, or chosen.
      if (got.kind === "picture") close(got);
      return;
    }
    reading.value = null;
    adopt(got, takeSeries);
  } catch (problem) {
    if (signal.aborted || isStopped(problem)) return;
    reading.value = null;
    notify({ kind: "error", text: messages.stageUnchanged(wordsOf(problem)) });
  }
}

function adopt(got: Opened, takeSeries: (series: OpenedSeries) => void): void {
  if (got.kind === "series") {
    takeSeries(got);
    return;
  }
  takeSource(got.kind === "picture" ? { kind: "picture", name: got.name, picture: got } : ofOutlines(got));
  for (const warning of got.warnings) notify({ kind: "info", text: warning.message });
  announce(messages.isOnStage(got.name));
}

function ofOutlines({ name, outlines }: OpenedOutlines): Source {
  return { kind: "outlines", name, outlines, chosen: 0 };
}

// Where what was opened lies in the plane: all of it in a square of side 2 about the origin, whatever its units.

export interface Frame {
  /** Of the source. */
  x: number;
  y: number;
  /** Units of the plane a unit of the source. */
  scale: number;
}

export const PLAIN: Frame = { x: 0, y: 0, scale: 1 };

/** The frame of a rectangle from the origin: that of a picture. */
export function frameOfSize(width: number, height: number): Frame {
  return { x: width / 2, y: height / 2, scale: 2 / Math.max(width, height, 1) };
}

export function frameOfPoints(points: Float64Array): Frame {
  const { x0, y0, x1, y1 } = boxOf(points);
  const size = Math.max(x1 - x0, y1 - y0);
  return { x: (x0 + x1) / 2, y: (y0 + y1) / 2, scale: size > 0 && Number.isFinite(size) ? 2 / size : 1 };
}

/** x0, y0, x1, y1, .. of the source in the plane. */
export function framed(points: Float64Array, { x, y, scale }: Frame): Float64Array {
  return points.map((z, i) => (z - (i % 2 === 0 ? x : y)) * scale);
}

/** The box of x0, y0, x1, y1, ..; without points the square of side 2. */
export const boxOf = (points: Float64Array): Box => boxOfPoints(points) ?? { x0: -1, y0: -1, x1: 1, y1: 1 };

/** The name of a fit: that of its file without the ending, as long as links allow. */
export function plainName(name: string): string {
  return name.replace(/\.[a-z]{3,7}$/i, "").slice(0, 40) || messages.leaf;
}
