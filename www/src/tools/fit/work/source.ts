/** What is fitted: a file that was opened, a leaf grown by program, or the curve that a link brought. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import type { KeptPhotograph } from "#document/kept/fits";
import { announce, notify, wordsOf } from "#document/notice";
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

export const FIRST: Source = { kind: "grown", name: messages.mapleLeaf, grown: "sugar-maple", seed: 1 };

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
