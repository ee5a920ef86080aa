import type { Space, SpaceView } from "#wasm/api";
import type { FileBytes, FilmSettings } from "../space/export";
import type { PictureRequest } from "../space/picture";
import { crew, painters } from "./crew";
import { Frames } from "./frames";
import { inOrder } from "./order";

interface FilmRequest extends FilmSettings {
  space: Space;
  /** From where, where no key says so. */
  view: SpaceView;
  /** Seconds. */
  times: number[];
  factor: 1 | 2;
  palette: string[];
}

export interface Film extends FileBytes {
  /** Frames that stand for moments without an attractor. */
  missing: number;
}

/** What has been made so far; now and then with what was drawn last, small. */
type OnFrame = (done: number, preview: ImageBitmap | null) => void;

/** Milliseconds from one preview to the next. */
const PREVIEW = 250;
const PREVIEW_SIDE = 720;
/** So many small frames choose the colours of a GIF. */
const SAMPLES = 8;
const SAMPLE_SIDE = 160;

/** Complete pictures, frame by frame, and the file of them. Rejected when called off. */
export async function makeFilm(request: FilmRequest, signal: AbortSignal, onFrame: OnFrame): Promise<Film> {
  const { times, width, height, factor } = request;
  const { task, end } = crew();
  const frames = new Frames(request.space);
  const hands = painters(width * height * factor * factor, globalThis.navigator?.hardwareConcurrency ?? 2);
  const options = { signal };
  try {
    const { kind, fps, bitrate, ground } = request;
    const samples = kind === "gif" ? { samples: await sampled(request, frames, task, signal) } : {};
    await task("filmBegin", { kind, width, height, fps, bitrate, ground, ...samples }, options);
    frames.missing = 0;
    let shown = "";
    let told = 0;
    await inOrder(
      times.length,
      2 * hands,
      async (i) => {
        const next = pictureAt(request, frames, times[i] ?? 0, request);
        const key = JSON.stringify([next.objects, next.view]);
        // What stays as it was is not drawn again.
        if (key === shown) return null;
        shown = key;
        // The lane 0 writes the file.
        return task("picture", next, { signal, lane: 1 + (i % hands) });
      },
      async (i, picture) => {
        const now = performance.now();
        let preview: ImageBitmap | null = null;
        if (picture && (now - told >= PREVIEW || i === times.length - 1)) {
          told = now;
          preview = await small(picture.data, width, height);
        }
        if (picture) {
          await task("filmAdd", { pixels: picture.data }, { signal, transfer: [picture.data.buffer] });
        } else await task("filmAdd", {}, options);
        onFrame(i + 1, preview);
      },
    );
    const file = await task("filmEnd", {}, options);
    return { ...file, missing: frames.missing };
  } finally {
    end();
    frames.free();
  }
}

type Task = ReturnType<typeof crew>["task"];

/** Some frames of all, small, one below the other. */
async function sampled(request: FilmRequest, frames: Frames, task: Task, signal: AbortSignal) {
  const { times, width, height } = request;
  const scale = Math.min(1, SAMPLE_SIDE / Math.max(width, height));
  const size = {
    width: Math.max(1, Math.round(width * scale)),
    height: Math.max(1, Math.round(height * scale)),
  };
  const count = Math.min(SAMPLES, times.length);
  const all = new Uint8ClampedArray(4 * size.width * size.height * count);
  for (let i = 0; i < count; i++) {
    const time = times[Math.floor((i * times.length) / count)] ?? 0;
    const { data } = await task("picture", pictureAt(request, frames, time, size), { signal, lane: 1 });
    all.set(data, i * data.length);
  }
  return all;
}

/** What is drawn of a moment. */
export function pictureAt(
  request: Pick<FilmRequest, "space" | "view" | "palette" | "ground" | "factor">,
  frames: Frames,
  time: number,
  { width, height }: { width: number; height: number },
): PictureRequest {
  const { space, view, palette, ground, factor } = request;
  const frame = frames.at(time);
  const objects = frame.objects.map(({ now }, i) => {
    const tint = space.objects[i]?.tint;
    return tint === undefined ? { maps: now } : { maps: now, tint };
  });
  return { objects, view: frame.view ?? view, light: space.light, width, height, factor, palette, ground };
}

async function small(
  pixels: Uint8ClampedArray<ArrayBuffer>,
  width: number,
  height: number,
): Promise<ImageBitmap | null> {
  if (typeof createImageBitmap === "undefined") return null;
  const scale = Math.min(1, PREVIEW_SIDE / Math.max(width, height));
  const size = {
    resizeWidth: Math.max(1, Math.round(width * scale)),
    resizeHeight: Math.max(1, Math.round(height * scale)),
    resizeQuality: "medium" as const,
  };
  return createImageBitmap(new ImageData(pixels, width, height), size).catch(() => null);
}
