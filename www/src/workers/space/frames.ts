import type { MapRow3, Point3, Repeat, Space, SpaceFrame, SpaceView } from "#wasm/api";
import { type SpaceMotionHandle, solid } from "#wasm/space";

/** The parameters of one frame, as a file has them. */
export interface FrameRecord {
  time: number;
  view: { eye: Point3; target: Point3; turn: number; tilt: number; angle: number };
  objects: { name: string; maps: MapRow3[] }[];
}

export function frameRecord(
  space: Pick<Space, "objects">,
  time: number,
  frame: SpaceFrame,
  fallback: SpaceView,
): FrameRecord {
  const { target, distance, turn, tilt, angle } = frame.view ?? fallback;
  const flat = Math.cos(tilt);
  const eye: Point3 = [
    target[0] + distance * Math.sin(turn) * flat,
    target[1] - distance * Math.cos(turn) * flat,
    target[2] + distance * Math.sin(tilt),
  ];
  const objects = frame.objects.map(({ now }, i) => ({ name: space.objects[i]?.name ?? "", maps: now }));
  return { time, view: { eye, target, turn, tilt, angle }, objects };
}

/** What a file says of its frames: what they are made of, so that they can be read back, and how they go. */
export interface FramesHead {
  packed: string;
  at: number;
  view: SpaceView;
  loop: Repeat;
  fps: number;
  seconds: number;
}

/** Frames as a file: each of them is text already. */
export function framesText(about: FramesHead, frames: readonly string[]): string {
  const { packed, at, view, loop, fps, seconds } = about;
  const head = JSON.stringify({ frond: "frames", packed, at, view, loop, fps, seconds });
  return `${head.slice(0, -1)},"frames":[\n${frames.join(",\n")}\n]}\n`;
}

/** Frames one after the other. Where a moment has no attractor the frame before it stands, as on the stage. */
export class Frames {
  readonly #motion: SpaceMotionHandle;
  #last: SpaceFrame | null = null;
  /** How many moments had none. */
  missing = 0;

  constructor(space: Space) {
    this.#motion = new solid.SpaceMotion(space);
  }

  at(time: number): SpaceFrame {
    try {
      this.#last = this.#motion.at(time);
    } catch (problem) {
      if (!this.#last) throw problem;
      this.missing++;
    }
    return this.#last;
  }

  free(): void {
    this.#motion.free();
  }
}
