import type { Space } from "#wasm/api";
import { Frames, type FramesHead, frameRecord, framesText } from "../film/frames";
import { gifSink } from "../film/gif";
import { layOn } from "../film/opaque";
import type { FrameSize, Sink } from "../film/sink";
import { codecFor, type FilmCodec, videoSink } from "../film/video";
import type { Context } from "../lanes/task";
import { type PictureRequest, pictureTasks } from "./picture";

export interface FilmSettings extends FrameSize {
  kind: "mp4" | "webm" | "gif";
  /** Bits a second, of videos. */
  bitrate: number;
  ground: string;
  /** Pixels of some frames, which choose the colours of a GIF. */
  samples?: Uint8ClampedArray<ArrayBuffer>;
}

export interface FileBytes {
  bytes: Uint8Array<ArrayBuffer>;
  type: string;
}

/** Which kinds of video this browser can write. */
export interface Encodable {
  mp4: FilmCodec | null;
  webm: FilmCodec | null;
}

interface Film {
  sink: Sink;
  settings: FilmSettings;
  last: Uint8ClampedArray<ArrayBuffer> | null;
}

const TYPES = { mp4: "video/mp4", webm: "video/webm", gif: "image/gif" } as const;
const UNABLE = {
  code: "export-unable",
  message: "This browser cannot write such a video. Choose another size, WebM or GIF.",
};
const FILM = "film";

export const exportTasks = {
  async encodable(_: Context, settings: FrameSize & { bitrate: number }): Promise<Encodable> {
    return { mp4: await codecFor("mp4", settings), webm: await codecFor("webm", settings) };
  },

  /** A complete picture, and how many milliseconds it took, waiting aside. */
  async measured(context: Context, request: PictureRequest) {
    const began = performance.now();
    const picture = await pictureTasks.picture(context, request);
    return { ...picture, took: performance.now() - began };
  },

  /** Begins a film. Its frames come one by one, to the same lane. */
  async filmBegin({ keep }: Context, settings: FilmSettings): Promise<void> {
    keep.set(FILM, { sink: await sinkFor(settings), settings, last: null } satisfies Film);
  },

  /** The next frame, RGBA with straight alpha; none: the last one once more. */
  async filmAdd({ keep }: Context, { pixels }: { pixels?: Uint8ClampedArray<ArrayBuffer> }): Promise<void> {
    const film = filmIn(keep);
    if (pixels) {
      layOn(pixels, film.settings.ground);
      film.last = pixels;
    }
    if (film.last) await film.sink.add(film.last);
  },

  async filmEnd({ keep, transfer }: Context, _: Record<string, never>): Promise<FileBytes> {
    const { sink, settings } = filmIn(keep);
    keep.delete(FILM);
    const bytes = await sink.finish();
    transfer(bytes.buffer);
    return { bytes, type: TYPES[settings.kind] };
  },

  /** The parameters of every frame, as text. */
  async parameters(
    context: Context<number>,
    request: FramesHead & { space: Space; times: number[] },
  ): Promise<FileBytes & { missing: number }> {
    const { space, view, times } = request;
    const frames = new Frames(space);
    try {
      const texts: string[] = [];
      for (const [i, time] of times.entries()) {
        texts.push(JSON.stringify(frameRecord(space, time, frames.at(time), view)));
        if (i % 50 === 49) {
          context.progress(i + 1);
          await context.breathe();
        }
      }
      const bytes = new TextEncoder().encode(framesText(request, texts));
      context.transfer(bytes.buffer);
      return { bytes, type: "application/json", missing: frames.missing };
    } finally {
      frames.free();
    }
  },
};

function filmIn(keep: Context["keep"]): Film {
  const film = keep.get(FILM) as Film | undefined;
  if (!film) throw { code: "export-lost", message: "The film was lost on the way. Make it again." };
  return film;
}

async function sinkFor(settings: FilmSettings): Promise<Sink> {
  if (settings.kind === "gif") {
    return gifSink({ ...settings, samples: settings.samples ?? new Uint8ClampedArray(4) });
  }
  const codec = await codecFor(settings.kind, settings);
  if (!codec) throw UNABLE;
  return videoSink(settings.kind, codec, settings);
}
