import type { Chroma } from "./yuv";

/** What takes frames one after the other and becomes a file. */
export interface Sink {
  /** RGBA, row 0 on top: opaque, but where the film has no ground. It is not kept. */
  add(pixels: Uint8ClampedArray<ArrayBuffer>): Promise<void>;
  finish(): Promise<Uint8Array<ArrayBuffer>>;
  /** Leaves it unfinished. */
  drop(): Promise<void>;
}

export interface FrameSize {
  width: number;
  height: number;
  /** Frames a second. */
  fps: number;
}

/** Which kind of file, and how. */
export interface FilmSettings extends FrameSize {
  kind: FilmKind;
  /** Bits a second, of videos. */
  bitrate: number;
  /** "#rrggbb"; null leaves clear what is clear, where the kind can. */
  ground: string | null;
  /** Of videos: what of it has room for colours; without it four pixels share one. */
  chroma?: Chroma;
  /** Each frame comes so many times as wide and as high as it is in the file. */
  drawn?: 1 | 2;
  /** Of a GIF: whether colours that it does not have are mixed from dots; null: where that looks better. */
  dither: boolean | null;
  /** Pixels of some frames, which choose the colours of a GIF. */
  samples?: Uint8ClampedArray<ArrayBuffer>;
}

/** Videos, moving pictures, and the frames one by one. */
export type FilmKind = "mp4" | "webm" | "gif" | "apng" | "zip";
