import type { FrameSize, Sink } from "./sink";
import { type Chroma, COLOUR_SPACE, planesOf } from "./yuv";

type VideoKind = "mp4" | "webm";
export type FilmCodec = "avc" | "vp9" | "vp8" | "av1";

/** What a video is written with. */
export interface Coding {
  codec: FilmCodec;
  chroma: Chroma;
  /** The codec with its profile, where the usual one will not do. */
  fullCodecString?: string;
}

/** What plays almost everywhere comes first. */
const CODECS: Record<VideoKind, readonly FilmCodec[]> = { mp4: ["avc"], webm: ["vp9", "vp8"] };

interface VideoSettings extends FrameSize {
  /** Bits a second. */
  bitrate: number;
  /** null: what is clear stays clear. */
  ground?: string | null;
}

/** What this browser can write such a video with, or null. */
export async function codingFor(
  kind: VideoKind,
  settings: VideoSettings,
  chroma: Chroma = "420",
): Promise<Coding | null> {
  if (typeof VideoEncoder === "undefined") return null;
  const { Quality, canEncodeVideo } = await import("mediabunny");
  const { width, height, fps, bitrate, ground } = settings;
  const usual = CODECS[kind].map((codec): Coding => ({ codec, chroma: "420" }));
  // What is clear is written beside the picture, by codecs that have no room for more.
  const wide = chroma === "444" && ground !== null ? wideCodings(width * height) : [];
  for (const coding of chroma === "444" ? wide : usual) {
    const { codec, chroma: _chroma, ...profile } = coding;
    const able = canEncodeVideo(codec, {
      width,
      height,
      frameRate: fps,
      quality: new Quality({ bitrate }),
      ...profile,
      ...alphaOf(ground),
    });
    if (!(await able.catch(() => false))) continue;
    if (coding.chroma === "420" || (await keepsColours(profile.fullCodecString ?? ""))) return coding;
  }
  return null;
}

/**
 * VP9 in profile 1 and AV1 in profile 1 have a colour for every pixel (VP9 bitstream specification, section 7.2; AV1,
 * section 6.4.1). After the level come 8 bits, and then what the planes are. Either plays in MP4 and in WebM.
 */
function wideCodings(pixels: number): Coding[] {
  const [vp9, av1] = pixels <= 983_040 ? ["41", "09M"] : pixels <= 8_912_896 ? ["52", "14M"] : ["62", "18M"];
  return [
    { codec: "vp9", chroma: "444", fullCodecString: `vp09.01.${vp9}.08.03.01.13.01.00` },
    { codec: "av1", chroma: "444", fullCodecString: `av01.1.${av1}.08.0.000.01.13.01.0` },
  ];
}

const kept = new Map<string, Promise<boolean>>();

/** Whether what is encoded has a colour for every pixel when it is decoded: some encoders say so, and share them. */
function keepsColours(codec: string): Promise<boolean> {
  const known = kept.get(codec) ?? tried(codec).catch(() => false);
  kept.set(codec, known);
  return known;
}

const TRIAL = 64;

async function tried(codec: string): Promise<boolean> {
  if (typeof VideoDecoder === "undefined") return false;
  let found: string | null = null;
  const decoder = new VideoDecoder({
    output(frame) {
      found = frame.format;
      frame.close();
    },
    error: () => {},
  });
  const encoder = new VideoEncoder({
    output(chunk, about) {
      if (about?.decoderConfig) decoder.configure(about.decoderConfig);
      decoder.decode(chunk);
    },
    error: () => {},
  });
  try {
    encoder.configure({ codec, width: TRIAL, height: TRIAL, bitrate: 1e6, framerate: 30 });
    const grey = new Uint8Array(3 * TRIAL * TRIAL).fill(128);
    const size = { codedWidth: TRIAL, codedHeight: TRIAL };
    const frame = new VideoFrame(grey, { format: "I444", ...size, timestamp: 0, colorSpace: COLOUR_SPACE });
    encoder.encode(frame, { keyFrame: true });
    frame.close();
    await encoder.flush();
    await decoder.flush();
    return found === "I444";
  } finally {
    if (encoder.state !== "closed") encoder.close();
    if (decoder.state !== "closed") decoder.close();
  }
}

/** A video file in the making. */
export async function videoSink(
  kind: VideoKind,
  { codec, chroma, ...profile }: Coding,
  { width, height, fps, bitrate, ground }: VideoSettings,
): Promise<Sink> {
  const { BufferTarget, Mp4OutputFormat, Output, Quality, VideoSample, VideoSampleSource, WebMOutputFormat } =
    await import("mediabunny");
  const target = new BufferTarget();
  // What is played while it is still fetched begins at once where its index comes first.
  const format = kind === "mp4" ? new Mp4OutputFormat({ fastStart: "in-memory" }) : new WebMOutputFormat();
  const output = new Output({ format, target });
  const source = new VideoSampleSource({
    codec,
    quality: new Quality({ bitrate }),
    keyFrameInterval: 2,
    ...profile,
    ...alphaOf(ground),
  });
  output.addVideoTrack(source, { frameRate: fps });
  await output.start();
  let frame = 0;
  return {
    async add(pixels) {
      const about = {
        codedWidth: width,
        codedHeight: height,
        timestamp: frame / fps,
        duration: 1 / fps,
      };
      // Browsers choose the range and the matrix of colours themselves, and players that are told neither guess.
      const sample =
        ground === null
          ? new VideoSample(pixels, { ...about, format: "RGBA" })
          : new VideoSample(planesOf(pixels, width, height, chroma), {
              ...about,
              format: chroma === "444" ? "I444" : "I420",
              colorSpace: COLOUR_SPACE,
            });
      frame++;
      try {
        // Waits while the encoder has more than enough to do.
        await source.add(sample);
      } finally {
        sample.close();
      }
    },
    async finish() {
      await output.finalize();
      if (!target.buffer) throw new Error("The video could not be finished.");
      return new Uint8Array(target.buffer);
    },
    async drop() {
      if (output.state !== "finalized") await output.cancel();
    },
  };
}

const alphaOf = (ground: string | null | undefined) => (ground === null ? { alpha: "keep" as const } : {});
