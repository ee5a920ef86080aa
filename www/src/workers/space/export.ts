import type { Space } from "#wasm/api";
import type { FileBytes } from "../film/encode";
import type { Context } from "../lanes/task";
import { Frames, type FramesHead, frameRecord, framesText } from "./frames";
import { type PictureRequest, pictureTasks } from "./picture";

export const exportTasks = {
  /** A complete picture, and how many milliseconds it took, waiting aside. */
  async measured(context: Context, request: PictureRequest) {
    const began = performance.now();
    const picture = await pictureTasks.picture(context, request);
    return { ...picture, took: performance.now() - began };
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
