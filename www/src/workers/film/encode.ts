/** The tasks of the worker that writes a film: its frames come one by one, to the same lane. */
import type { Context } from "../lanes/task";
import { apngSink } from "./format/apng";
import { gifSink } from "./format/gif";
import { halved } from "./format/halved";
import { PngFile } from "./format/png-file";
import type { FilmSettings, FrameSize, Sink } from "./format/sink";
import { codingFor, videoSink } from "./format/video";
import { zipSink } from "./format/zip";
import { layOn } from "./opaque";
import { type InsetMap, overlaid } from "./overlay";
import type { Place } from "./subject";

export interface FileBytes {
  bytes: Uint8Array<ArrayBuffer>;
  type: string;
}

/** Which kinds of video this browser can write. */
export interface Encodable {
  mp4: boolean;
  webm: boolean;
  /** The same with a colour for every pixel. */
  fullColour: boolean;
}

interface Film {
  sink: Sink;
  settings: FilmSettings;
  /** The frame before, on its ground. */
  last: Uint8ClampedArray<ArrayBuffer> | null;
  map: InsetMap | null;
}

/** A picture in the making. */
interface Picture {
  file: PngFile;
  ground: string | null;
}

export interface PictureSettings {
  width: number;
  height: number;
  /** "#rrggbb"; null leaves clear what is clear. */
  ground: string | null;
  /** The address that it carries, if it is to. */
  link: string | null;
}

const TYPES = {
  mp4: "video/mp4",
  webm: "video/webm",
  gif: "image/gif",
  apng: "image/png",
  zip: "application/zip",
} as const;
const UNABLE = {
  code: "export-unable",
  message: "This browser cannot write such a video. Choose another size, WebM or GIF.",
};
const FILM = "film";
const PICTURE = "picture-file";

export const encodeTasks = {
  async encodable(_: Context, settings: FrameSize & { bitrate: number }): Promise<Encodable> {
    return {
      mp4: (await codingFor("mp4", settings)) !== null,
      webm: (await codingFor("webm", settings)) !== null,
      // Both kinds hold the same codecs.
      fullColour: (await codingFor("webm", settings, "444")) !== null,
    };
  },

  async filmBegin({ keep }: Context, { map, ...settings }: FilmSettings & { map?: InsetMap }): Promise<void> {
    keep.set(FILM, { sink: await sinkFor(settings), settings, last: null, map: map ?? null } satisfies Film);
  },

  /** Begins a picture, whose rows come from the top, to the same lane. */
  async pictureBegin({ keep }: Context, settings: PictureSettings): Promise<void> {
    const { ground } = settings;
    const file = new PngFile({ ...settings, opaque: ground !== null });
    keep.set(PICTURE, { file, ground } satisfies Picture);
  },

  /** The next rows of the picture, RGBA with straight alpha. */
  async pictureAdd({ keep }: Context, pixels: Uint8ClampedArray<ArrayBuffer>): Promise<void> {
    const { file, ground } = pictureIn(keep);
    if (ground !== null) layOn(pixels, ground);
    await file.add(pixels);
  },

  async pictureEnd({ keep, transfer }: Context, _: Record<string, never>): Promise<FileBytes> {
    const { file } = pictureIn(keep);
    keep.delete(PICTURE);
    const bytes = await file.finish();
    transfer(bytes.buffer);
    return { bytes, type: TYPES.apng };
  },

  /** The next frame, RGBA with straight alpha, as large as it is drawn; none: the last one once more. */
  async filmAdd(
    { keep }: Context,
    { pixels, words, at }: { pixels?: Uint8ClampedArray<ArrayBuffer>; words?: string; at?: Place },
  ): Promise<void> {
    const film = filmIn(keep);
    const { settings, map } = film;
    if (pixels) {
      const { width, height, drawn } = settings;
      const made = drawn === 2 ? halved(pixels, 2 * width, 2 * height) : pixels;
      if (settings.ground !== null) layOn(made, settings.ground);
      film.last = made;
    }
    if (!film.last) return;
    const over = { ...(words ? { words } : {}), ...(map && at ? { inset: { map, at } } : {}) };
    const bare = over.words === undefined && over.inset === undefined;
    await film.sink.add(bare ? film.last : overlaid(film.last, settings, over));
  },

  async filmEnd({ keep, transfer }: Context, _: Record<string, never>): Promise<FileBytes> {
    const { sink, settings } = filmIn(keep);
    keep.delete(FILM);
    const bytes = await sink.finish();
    transfer(bytes.buffer);
    return { bytes, type: TYPES[settings.kind] };
  },
};

function filmIn(keep: Context["keep"]): Film {
  const film = keep.get(FILM) as Film | undefined;
  if (!film) throw { code: "export-lost", message: "The film was lost on the way. Make it again." };
  return film;
}

function pictureIn(keep: Context["keep"]): Picture {
  const picture = keep.get(PICTURE) as Picture | undefined;
  if (!picture) throw { code: "export-lost", message: "The picture was lost on the way. Save it again." };
  return picture;
}

async function sinkFor(settings: FilmSettings): Promise<Sink> {
  const { kind } = settings;
  if (kind === "gif") return gifSink(settings);
  if (kind === "apng") return apngSink(settings);
  if (kind === "zip") return zipSink(settings);
  const coding = await codingFor(kind, settings, settings.chroma);
  const usual = coding ?? (await codingFor(kind, settings));
  if (!usual) throw UNABLE;
  return videoSink(kind, usual, settings);
}
