/** A busy graphics card makes frames wait; the field does not wait longer than this with it. */
const LATEST_MS = 80;

/** Paints at most once a frame. */
export class Soon {
  readonly #paint: () => void;
  #frame = 0;
  #late: ReturnType<typeof setTimeout> | undefined;

  constructor(paint: () => void) {
    this.#paint = paint;
  }

  /** At once when it is complete, or where there are no frames, in a hidden tab. */
  ask(complete: boolean): void {
    if (complete || document.hidden) this.now();
    else if (!this.#frame) {
      this.#frame = requestAnimationFrame(() => this.now());
      this.#late = setTimeout(() => this.now(), LATEST_MS);
    }
  }

  now(): void {
    this.cancel();
    this.#paint();
  }

  cancel(): void {
    cancelAnimationFrame(this.#frame);
    clearTimeout(this.#late);
    this.#frame = 0;
  }
}
