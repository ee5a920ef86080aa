/** The film in the making: it goes on while the dialog is closed. */

import { type ReadonlySignal, signal } from "@preact/signals";
import { notify, wordsOf } from "#document/notice";
import { downloadFrom } from "#ui/files/download";
import { type Film, makeFilm } from "#workers/film/film";
import * as messages from "./messages";
import { exportOpen, filmProgress, filmUnseen } from "./open";
import { bitrateOf, canBeClear, fileName, isFilm, type Plan, secondsLeft, timesOf } from "./plan";
import { framesGo } from "./settings";
import type { FilmSubject } from "./subject";

export interface Job {
  plan: Plan;
  name: string;
  done: number;
  of: number;
  /** Seconds. */
  left: number | null;
  preview: ImageBitmap | null;
}

export interface Made {
  plan: Plan;
  name: string;
  blob: Blob;
  /** Stays good until there is another. */
  url: string;
  frames: number;
  missing: number;
}

const running = signal<Job | null>(null);
const finished = signal<Made | null>(null);
export const job: ReadonlySignal<Job | null> = running;
export const made: ReadonlySignal<Made | null> = finished;

let stop: AbortController | null = null;

/** Makes it, and saves it. */
export async function make(subject: FilmSubject, plan: Plan): Promise<void> {
  if (running.peek()) return;
  const name = fileName(subject.name, plan);
  const times = plan.kind === "keys" ? [] : timesOf(plan, framesGo.peek());
  const began = performance.now();
  const ending = new AbortController();
  stop = ending;
  running.value = { plan, name, done: 0, of: times.length, left: null, preview: null };
  filmProgress.value = 0;
  addEventListener("beforeunload", warn);
  const onFrame = (done: number, preview: ImageBitmap | null = null) => {
    const now = running.peek();
    if (!now || ending.signal.aborted) {
      preview?.close();
      return;
    }
    if (preview) now.preview?.close();
    const left = secondsLeft(done, now.of, (performance.now() - began) / 1000);
    running.value = { ...now, done, left, preview: preview ?? now.preview };
    filmProgress.value = done / now.of;
  };
  try {
    const film = await filmOf(subject, plan, times, ending.signal, onFrame);
    finish({ plan, name, frames: times.length }, film);
  } catch (problem) {
    if (!ending.signal.aborted) {
      notify({ kind: "error", text: messages.exportFailed(wordsOf(problem)) });
    }
  } finally {
    removeEventListener("beforeunload", warn);
    running.peek()?.preview?.close();
    running.value = null;
    filmProgress.value = null;
    stop = null;
  }
}

function filmOf(
  subject: FilmSubject,
  plan: Plan,
  times: number[],
  signal: AbortSignal,
  onFrame: (done: number, preview?: ImageBitmap | null) => void,
): Promise<Film> {
  const { kind, width, height, fps, samples, fullColour, photograph, captions, dither, inset } = plan;
  if (!isFilm(kind)) {
    if (!subject.numbers) throw new Error(messages.thereNoNumbersTo);
    return subject.numbers.make(plan, times, signal, onFrame);
  }
  const ground = plan.clear && canBeClear(kind) ? null : (plan.ground ?? subject.ground);
  const chroma = fullColour ? ("444" as const) : ("420" as const);
  const settings = { kind, width, height, fps, bitrate: bitrateOf(plan), ground, dither, chroma };
  return makeFilm({ subject, times, settings, samples, photograph, captions, inset }, signal, onFrame);
}

export function cancel(): void {
  stop?.abort();
}

function finish(what: Pick<Made, "plan" | "name" | "frames">, { bytes, type, missing }: Film): void {
  forget();
  const blob = new Blob([bytes], { type });
  const result = { ...what, blob, url: URL.createObjectURL(blob), missing };
  finished.value = result;
  save(result);
  filmUnseen.value = exportOpen.peek() !== "film";
}

/** What was made is let go. */
export function forget(): void {
  const old = finished.peek();
  finished.value = null;
  filmUnseen.value = false;
  if (old) setTimeout(() => URL.revokeObjectURL(old.url), 10_000);
}

export function save({ url, name }: Pick<Made, "url" | "name">): void {
  downloadFrom(url, name);
}

/** Whoever leaves the page loses the film. */
function warn(event: BeforeUnloadEvent): void {
  event.preventDefault();
}
