import { filmCrew } from "./client";
import type { FileBytes, PictureSettings } from "./encode";
import { inOrder } from "./order";
import type { FramePixels, Subject } from "./subject";

export interface PictureRequest {
  subject: Subject;
  /** The moment, in seconds. */
  at: number;
  settings: PictureSettings;
  smooth: boolean;
}

/** Pixels that are drawn at a time. */
const STRIP = 1 << 21;

/** A complete picture as a file, drawn in strips where it can be. Rejected when called off. */
export async function makePicture(
  { subject, at, settings, smooth }: PictureRequest,
  signal: AbortSignal,
  onDone: (part: number) => void,
): Promise<FileBytes> {
  const { width, height } = settings;
  const { task, end } = filmCrew();
  const drawer = subject.drawer({ width, height, smooth, ground: settings.ground ?? subject.ground });
  const options = { signal };
  try {
    await task("pictureBegin", settings, options);
    const inStrips = drawer.strip !== undefined;
    const count = inStrips ? Math.max(1, Math.floor(STRIP / width)) : height;
    await inOrder<FramePixels | null>(
      Math.ceil(height / count),
      2 * drawer.hands,
      async (i) => {
        const top = i * count;
        const rows = { top, count: Math.min(count, height - top) };
        return (await drawer.strip?.(at, rows, signal)) ?? drawer.frame(at, signal);
      },
      async (i, pixels) => {
        if (!pixels) throw { code: "no-picture", message: "There is no picture of this moment." };
        await task("pictureAdd", pixels.data, { signal, transfer: [pixels.data.buffer] });
        onDone(Math.min(1, ((i + 1) * count) / height));
      },
    );
    return await task("pictureEnd", {}, options);
  } finally {
    end();
    drawer.end();
  }
}
