import * as messages from "../messages";
import type { PainterState } from "./painter";
import type { Pixels } from "./surface";

/** What a painter that needs no device has: one canvas behind all else of its host, and a state that it tells. */
export abstract class CanvasPainter {
  protected readonly canvas = document.createElement("canvas");
  readonly #onState: (state: PainterState) => void;
  #state: PainterState = {
    backend: "canvas",
    complete: false,
    settled: false,
    points: 0,
    empty: false,
    preview: false,
  };

  constructor(host: HTMLElement, onState: (state: PainterState) => void) {
    this.canvas.setAttribute("aria-hidden", "true");
    host.prepend(this.canvas);
    this.#onState = onState;
  }

  async pixels(): Promise<Pixels> {
    const { width, height } = this.canvas;
    // Of a copy: a canvas that is read itself is drawn otherwise from then on.
    const copy = new OffscreenCanvas(Math.max(1, width), Math.max(1, height));
    const context = copy.getContext("2d", { willReadFrequently: true });
    if (!context) throw new Error(messages.thereNoPictureYet);
    context.drawImage(this.canvas, 0, 0);
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    return { width: copy.width, height: copy.height, data };
  }

  /** There is no device to lose. */
  forceLoss(): void {}

  close(): void {
    this.canvas.remove();
  }

  protected tell(change: Partial<PainterState>): void {
    this.#state = { ...this.#state, ...change };
    this.#onState(this.#state);
  }
}
