import type { Photograph } from "#document/deform/photograph";
import type { View } from "#geometry/coordinates";
import type { Bend } from "#wasm/api";
import { bends, type SheetHandle } from "#wasm/bend";
import type { Drawn } from "./surface";

/** What a bent picture is drawn with: lengths are device pixels. */
export interface SheetRequest {
  bend: Bend | null;
  parts: number;
  view: View;
  width: number;
  height: number;
}

const KEYS = ["bend", "parts", "view", "width", "height"] as const;

/** How long a picture may take while things move: it has fewer pixels a side where it takes longer. */
const MOST_MS = 60;
const COARSEST = 6;

/**
 * Bends a picture without a graphics card: coarse at once, complete when nothing changes any more. It comes after
 * `loadBends`.
 */
export class SheetPainter {
  readonly #photograph: Photograph;
  readonly #sheet: SheetHandle;
  #last: SheetRequest | null = null;
  #complete = false;
  #coarse = 3;

  constructor(photograph: Photograph) {
    this.#photograph = photograph;
    const { Sheet } = bends();
    this.#sheet = new Sheet(photograph.pixels, photograph.width, photograph.height);
  }

  /** Whether it is this picture that it draws. */
  shows(photograph: Photograph | null): boolean {
    return this.#photograph === photograph;
  }

  /** Brings the canvas up to date, or goes on with it. */
  draw(canvas: HTMLCanvasElement, request: SheetRequest): Drawn {
    const last = this.#last;
    const same = last !== null && KEYS.every((key) => last[key] === request[key]);
    if (!same || !this.#complete) {
      this.#last = request;
      this.#complete = same;
      this.#paint(canvas, request, same ? 1 : this.#coarse);
    }
    return { complete: this.#complete, settled: this.#complete, points: 0 };
  }

  #paint(canvas: HTMLCanvasElement, request: SheetRequest, coarse: number): void {
    const began = performance.now();
    const { view, bend, parts } = request;
    const width = Math.ceil(request.width / coarse);
    const height = Math.ceil(request.height / coarse);
    const pixels = this.#sheet.draw(bend, parts, {
      width,
      height,
      view: { ...view, scale: view.scale / coarse },
      smooth: coarse === 1,
    });
    canvas.width = width;
    canvas.height = height;
    canvas.getContext("2d")?.putImageData(image(pixels, width, height), 0, 0);
    if (coarse === 1) return;
    const took = performance.now() - began;
    if (took > MOST_MS) this.#coarse = Math.min(COARSEST, this.#coarse + 1);
    else if (took < MOST_MS / 3) this.#coarse = Math.max(2, this.#coarse - 1);
  }

  free(): void {
    this.#sheet.free();
  }
}

/** One picture of a bent picture, complete: after `loadBends`. */
export function bentPicture(photograph: Photograph, request: SheetRequest): ImageData {
  const { Sheet } = bends();
  const sheet = new Sheet(photograph.pixels, photograph.width, photograph.height);
  try {
    const { bend, parts, view, width, height } = request;
    return image(sheet.draw(bend, parts, { width, height, view }), width, height);
  } finally {
    sheet.free();
  }
}

/** What the module gives never lies in shared memory, which its declarations cannot say. */
function image(pixels: Uint8ClampedArray, width: number, height: number): ImageData {
  return new ImageData(pixels as Uint8ClampedArray<ArrayBuffer>, width, height);
}

/** The parts each way of the maps of a picture. */
export function partsOf(maps: readonly unknown[]): number {
  return maps.length === 9 ? 3 : 2;
}
