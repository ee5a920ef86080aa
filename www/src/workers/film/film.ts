import { filmCrew } from "./client";
import type { FileBytes } from "./encode";
import type { FilmSettings } from "./format/sink";
import { layOn } from "./opaque";
import { inOrder } from "./order";
import { overlaid } from "./overlay";
import { type FramePixels, type Samples, type Subject, sampling } from "./subject";

export interface FilmRequest {
  subject: Subject;
  /** Seconds, of each frame. */
  times: number[];
  settings: Omit<FilmSettings, "drawn" | "samples">;
  /** Looks at the subject for each pixel. */
  samples: Samples;
  /** Whether photographs lie in it, where it has some. */
  photograph: boolean;
  captions: boolean;
  /** Whether its small map lies over it, where it has one. */
  inset: boolean;
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
const SAMPLES = 12;
const SAMPLE_SIDE = 160;

/** Complete pictures, frame by frame, and the file of them. Rejected when called off. */
export async function makeFilm(request: FilmRequest, signal: AbortSignal, onFrame: OnFrame): Promise<Film> {
  const { subject, times, settings, captions } = request;
  const { smooth, drawn } = sampling(request.samples);
  const inset = request.inset ? subject.inset : undefined;
  const [width, height] = [drawn * settings.width, drawn * settings.height];
  const ground = settings.ground ?? subject.ground;
  const { task, end } = filmCrew();
  const drawer = subject.drawer({ width, height, smooth, ground, photograph: request.photograph });
  const options = { signal };
  try {
    const samples = settings.kind === "gif" ? { samples: await sampled(request, ground, signal) } : {};
    const map = inset ? { map: inset.map() } : {};
    await task("filmBegin", { ...settings, drawn, ...samples, ...map }, options);
    let told = 0;
    await inOrder<FramePixels | null>(
      times.length,
      2 * drawer.hands,
      (i) => drawer.frame(times[i] ?? 0, signal),
      async (i, picture) => {
        const now = performance.now();
        let preview: ImageBitmap | null = null;
        if (picture && (now - told >= PREVIEW || i === times.length - 1)) {
          told = now;
          preview = await small(picture.data, width, height);
        }
        const words = captions ? subject.caption?.(times[i] ?? 0) : undefined;
        const over = {
          ...(words === undefined ? {} : { words }),
          ...(inset ? { at: inset.at(times[i] ?? 0) } : {}),
        };
        if (picture) {
          const transfer = [picture.data.buffer];
          await task("filmAdd", { pixels: picture.data, ...over }, { signal, transfer });
        } else await task("filmAdd", over, options);
        onFrame(i + 1, preview);
      },
    );
    const file = await task("filmEnd", {}, options);
    return { ...file, missing: drawer.missing };
  } finally {
    end();
    drawer.end();
  }
}

/** Some frames of all, small, one below the other. */
async function sampled(
  { subject, times, settings, samples, photograph, inset }: FilmRequest,
  ground: string,
  signal: AbortSignal,
) {
  const scale = Math.min(1, SAMPLE_SIDE / Math.max(settings.width, settings.height));
  const width = Math.max(1, Math.round(settings.width * scale));
  const height = Math.max(1, Math.round(settings.height * scale));
  // What stands still, and the way back, has no colours of its own.
  const moments = [...new Set(times)];
  const count = Math.min(SAMPLES, moments.length);
  const all = new Uint8ClampedArray(4 * width * height * count);
  const { smooth } = sampling(samples);
  const drawer = subject.drawer({ width, height, smooth, ground, photograph }, { alone: true });
  const map = inset ? subject.inset?.map() : undefined;
  try {
    let data = new Uint8ClampedArray(4 * width * height);
    for (let i = 0; i < count; i++) {
      const time = moments[Math.floor((i * moments.length) / count)] ?? 0;
      const picture = await drawer.frame(time, signal);
      data = picture?.data ?? data;
      // Edges have colours between their own and the ground's.
      if (settings.ground !== null) layOn(data, settings.ground);
      // The small map has colours of its own.
      const at = map && subject.inset?.at(time);
      const seen = map && at ? overlaid(data, { ...settings, width, height }, { inset: { map, at } }) : data;
      all.set(seen, i * data.length);
    }
  } finally {
    drawer.end();
  }
  return all;
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
