import { bendsReady, loadBends, rasterize } from "#wasm/bend";
import type { Wanted } from "./surface";

/** As many pixels as are computed within a frame or two on an old telephone; of what is bent they take longer. */
const PIXELS = 600_000;
const BENT_PIXELS = 120_000;

/** The first picture: computed here and now, and shown until the renderer or the workers have been downloaded. */
export class Preview {
  readonly #canvas = document.createElement("canvas");
  readonly #onReady: () => void;
  #last: Wanted | null = null;

  /** `onReady` is told when there is more to draw with. */
  constructor(host: HTMLElement, onReady: () => void) {
    this.#onReady = onReady;
    this.#canvas.setAttribute("aria-hidden", "true");
    host.prepend(this.#canvas);
  }

  /** Whether there is something to see now. */
  show(request: Wanted): boolean {
    const { maps, bend, view, style, ratio } = request;
    if (request.picture) return false;
    if (bend && !bendsReady()) {
      // Nothing is shown unbent meanwhile. Whoever has the document says it where this fails.
      loadBends().then(this.#onReady, () => {});
      return false;
    }
    const last = this.#last;
    const same = last?.maps === maps && last.bend === bend && last.view === view;
    if (same && last.width === request.width) return true;
    this.#last = request;
    const coarse = Math.max(1, Math.sqrt((request.width * request.height) / (bend ? BENT_PIXELS : PIXELS)));
    const width = Math.ceil(request.width / coarse);
    const height = Math.ceil(request.height / coarse);
    if (width === 0 || height === 0) return false;
    try {
      const pixels = rasterize(
        { maps },
        {
          width,
          height,
          view: { ...view, scale: (view.scale * ratio) / coarse },
          colouring: style.colouring === "density" ? "map" : style.colouring,
          palette: style.palette,
          draft: true,
          ...(bend ? { bend } : {}),
        },
      );
      this.#canvas.width = width;
      this.#canvas.height = height;
      const image = new ImageData(new Uint8ClampedArray(pixels), width, height);
      this.#canvas.getContext("2d")?.putImageData(image, 0, 0);
      return true;
    } catch {
      // Maps without an attractor: the stage says so as soon as it is there.
      return false;
    }
  }

  close(): void {
    this.#canvas.remove();
  }
}
