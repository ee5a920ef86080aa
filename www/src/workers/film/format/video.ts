import type { FrameSize, Sink } from "./sink";

type VideoKind = "mp4" | "webm";
export type FilmCodec = "avc" | "vp9" | "vp8";

/** What plays almost everywhere comes first. */
const CODECS: Record<VideoKind, readonly FilmCodec[]> = { mp4: ["avc"], webm: ["vp9", "vp8"] };

interface VideoSettings extends FrameSize {
  /** Bits a second. */
  bitrate: number;
  /** null: what is clear stays clear. */
  ground?: string | null;
}

/** What this browser can write such a video with, or null. */
export async function codecFor(kind: VideoKind, settings: VideoSettings): Promise<FilmCodec | null> {
  if (typeof VideoEncoder === "undefined") return null;
  const { Quality, canEncodeVideo } = await import("mediabunny");
  const { width, height, fps, bitrate, ground } = settings;
  for (const codec of CODECS[kind]) {
    const able = canEncodeVideo(codec, {
      width,
      height,
      frameRate: fps,
      quality: new Quality({ bitrate }),
      ...alphaOf(ground),
    });
    if (await able.catch(() => false)) return codec;
  }
  return null;
}

/** A video file in the making. */
export async function videoSink(
  kind: VideoKind,
  codec: FilmCodec,
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
    ...alphaOf(ground),
  });
  output.addVideoTrack(source, { frameRate: fps });
  await output.start();
  let frame = 0;
  return {
    async add(pixels) {
      const sample = new VideoSample(pixels, {
        format: ground === null ? "RGBA" : "RGBX",
        codedWidth: width,
        codedHeight: height,
        timestamp: frame / fps,
        duration: 1 / fps,
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
