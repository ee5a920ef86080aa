import type { PictureRequest } from "#workers/space/complete-picture";

/** So long after the last change, in milliseconds, the picture is carved in full. */
export const REST_MS = 140;
/** How much coarser it is until then, each way. */
export const COARSE = 4;

/** Makes one picture, unless it is called off. */
type Carve = (request: PictureRequest, signal: AbortSignal) => Promise<ImageData>;

export interface Answers {
  paint(image: ImageData, whole: boolean): void;
  fail(problem: unknown): void;
}

/**
 * One picture at a time: first a coarse one, which comes to its end, so that something is seen during a drag, and at
 * rest one in full, which is given up as soon as another is wished for.
 */
export class Carving {
  private wish: { request: PictureRequest; answers: Answers } | null = null;
  private busy: { stop: AbortController; whole: boolean } | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** When the last wish came, and how long there has to be none after it. */
  private at = Number.NEGATIVE_INFINITY;
  private rest = 0;
  private readonly carve: Carve;

  constructor(carve: Carve) {
    this.carve = carve;
  }

  take(request: PictureRequest, answers: Answers): void {
    const now = performance.now();
    // After a pause nothing is dragged, and the full picture need not wait.
    this.rest = now - this.at < 4 * REST_MS ? REST_MS : 0;
    this.at = now;
    this.wish = { request, answers };
    clearTimeout(this.timer);
    if (this.busy?.whole) this.stop();
    if (!this.busy) void this.run(false);
  }

  end(): void {
    clearTimeout(this.timer);
    this.wish = null;
    this.stop();
  }

  private stop(): void {
    this.busy?.stop.abort();
    this.busy = null;
  }

  private async run(whole: boolean): Promise<void> {
    const wish = this.wish;
    if (!wish) return;
    const busy = { stop: new AbortController(), whole };
    this.busy = busy;
    const { width, height } = wish.request;
    const less = (x: number) => Math.max(1, Math.round(x / COARSE));
    const request = whole ? wish.request : { ...wish.request, width: less(width), height: less(height) };
    try {
      const image = await this.carve(request, busy.stop.signal);
      if (this.busy === busy) wish.answers.paint(image, whole);
    } catch (problem) {
      if (this.busy === busy) wish.answers.fail(problem);
    }
    if (this.busy !== busy) return;
    this.busy = null;
    if (whole) return;
    if (this.wish !== wish) void this.run(false);
    else
      this.timer = setTimeout(
        () => void this.run(true),
        Math.max(0, this.at + this.rest - performance.now()),
      );
  }
}
