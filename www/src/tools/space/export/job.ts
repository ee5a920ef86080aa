/** The film in the making: it goes on while the dialog is closed. */

import { type ReadonlySignal, signal } from "@preact/signals";
import { notify, wordsOf } from "#document/notice";
import { space, spacePart, spaceView } from "#document/space/space";
import { downloadFrom } from "#ui/files/download";
import { type Film, makeFilm } from "#workers/film/make";
import { spaceTask } from "#workers/space/client";
import { colours, ground } from "../stage/sight";
import { exportOpen, exportProgress, openExport } from "../time/exporting";
import { savedText } from "../time/saved/saved";
import { bitrateOf, bytesWords, fileName, isFilm, type Plan, secondsLeft, timesOf } from "./plan";
import { framesGo, loop } from "./settings";

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
export async function make(plan: Plan): Promise<void> {
  const scene = space.peek();
  const view = spaceView.peek();
  if (running.peek() || !scene || !view) return;
  const name = fileName(scene.objects, plan);
  const { packed, at } = spacePart.peek();
  if (plan.kind === "keys") {
    const bytes = new TextEncoder().encode(savedText({ packed, at, view, space: scene }));
    finish({ plan, name, frames: 0 }, { bytes, type: "application/json", missing: 0 });
    return;
  }
  const times = timesOf(plan, framesGo.peek());
  const began = performance.now();
  const ending = new AbortController();
  stop = ending;
  running.value = { plan, name, done: 0, of: times.length, left: null, preview: null };
  exportProgress.value = 0;
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
    exportProgress.value = done / now.of;
  };
  const moving = { space: scene, view, times };
  const { signal } = ending;
  try {
    const film = isFilm(plan.kind)
      ? await makeFilm(
          {
            ...moving,
            ...sizeOf(plan),
            kind: plan.kind,
            bitrate: bitrateOf(plan),
            factor: plan.smooth ? 2 : 1,
            palette: colours.peek(),
            ground: ground.peek(),
          },
          signal,
          onFrame,
        )
      : await spaceTask(
          "parameters",
          { ...moving, packed, at, loop: loop.peek(), fps: plan.fps, seconds: plan.to - plan.from },
          { lane: 1, signal, onProgress: (done) => onFrame(done) },
        );
    finish({ plan, name, frames: times.length }, film);
  } catch (problem) {
    if (!ending.signal.aborted) {
      notify({ kind: "error", text: `The export did not come to its end: ${wordsOf(problem)}` });
    }
  } finally {
    removeEventListener("beforeunload", warn);
    running.peek()?.preview?.close();
    running.value = null;
    exportProgress.value = null;
    stop = null;
  }
}

const sizeOf = ({ width, height, fps }: Plan) => ({ width, height, fps });

export function cancel(): void {
  stop?.abort();
}

function finish(what: Pick<Made, "plan" | "name" | "frames">, { bytes, type, missing }: Film): void {
  forget();
  const blob = new Blob([bytes], { type });
  const result = { ...what, blob, url: URL.createObjectURL(blob), missing };
  finished.value = result;
  save(result);
  if (exportOpen.peek()) return;
  notify({
    kind: "info",
    text: `${result.name} is made: ${bytesWords(blob.size)}.`,
    action: { label: "Show it", run: openExport },
  });
}

/** What was made is let go. */
export function forget(): void {
  const old = finished.peek();
  finished.value = null;
  if (old) setTimeout(() => URL.revokeObjectURL(old.url), 10_000);
}

export function save({ url, name }: Pick<Made, "url" | "name">): void {
  downloadFrom(url, name);
}

/** Whoever leaves the page loses the film. */
function warn(event: BeforeUnloadEvent): void {
  event.preventDefault();
}
