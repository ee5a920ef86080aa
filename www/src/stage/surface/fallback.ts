import type { Photograph } from "#document/deform/photograph";
import type { View } from "#geometry/coordinates";
import type { Bend, MapRow } from "#wasm/api";
import { bends, bendsReady, loadBends } from "#wasm/bend";
import { frond, type RenderStyle } from "#wasm/core";
import { Coalesce } from "#workers/pool/coalesce";
import { submit } from "#workers/pool/engine";
import { type Channel, type Job, single } from "#workers/pool/protocol";
import { partsOf, SheetPainter } from "./sheet";
import type { Drawn, Pixels, Surface, Wanted } from "./surface";

const KEYS = ["maps", "weights", "bend", "view", "style", "width", "height"] as const;

interface Request {
  maps: MapRow[];
  weights: number[] | undefined;
  bend: Bend | null;
  view: View;
  style: RenderStyle;
  width: number;
  height: number;
}

/** While things move, a picture with so many times fewer pixels a side comes first. */
const COARSE = 3;

/** Fills the canvas with pixels that a worker computes: slower than a graphics card, and never blank. */
export class Fallback implements Surface {
  readonly canvas: HTMLCanvasElement;
  readonly #onArrival: () => void;
  readonly #queue = new Coalesce(submit);
  readonly #channel: Channel;
  #wanted: Partial<Request> = {};
  #sheet: SheetPainter | null = null;
  #asked: Request | null = null;
  #arrived: Request | null = null;

  constructor(canvas: HTMLCanvasElement, channel: Channel, onArrival: () => void) {
    this.canvas = canvas;
    this.#onArrival = onArrival;
    this.#channel = channel;
  }

  lacks({ bend, picture }: Wanted): Promise<unknown> | null {
    return (bend || picture) && !bendsReady() ? loadBends() : null;
  }

  setMaps(maps: MapRow[], weights: number[] | undefined): void {
    // Throws where there is no attractor, as the renderer does.
    frond.bounds({ maps });
    this.#wanted = { ...this.#wanted, maps, weights };
  }

  setPicture(picture: Photograph | null): void {
    if (this.#sheet?.shows(picture)) return;
    this.#sheet?.free();
    this.#sheet = picture && new SheetPainter(picture);
    this.#asked = null;
  }

  setBend(bend: Bend | null): void {
    const { maps } = this.#wanted;
    // Throws where it cannot be had, as the renderer does.
    if (bend && maps) bends().bendFacts({ maps }, bend);
    this.#wanted = { ...this.#wanted, bend };
  }

  setView(view: View, ratio: number): void {
    this.#wanted = { ...this.#wanted, view: { ...view, scale: view.scale * ratio } };
  }

  setStyle(style: RenderStyle): void {
    this.#wanted = { ...this.#wanted, style };
  }

  resize(width: number, height: number): void {
    this.#wanted = { ...this.#wanted, width, height };
  }

  draw(_budget: number): Drawn {
    const { maps, weights, bend = null, view, style, width, height } = this.#wanted;
    if (!maps || !view || !style || !width || !height) return { complete: true, settled: true, points: 0 };
    if (this.#sheet) {
      return this.#sheet.draw(this.canvas, { bend, parts: partsOf(maps), view, width, height });
    }
    const asked = this.#asked;
    const request: Request = { maps, weights, bend, view, style, width, height };
    if (!asked || KEYS.some((key) => asked[key] !== request[key])) {
      this.#asked = request;
      this.#queue.request(() => this.#job(request, COARSE));
    }
    const complete = this.#arrived === this.#asked;
    return { complete, settled: complete, points: 0 };
  }

  #job(request: Request, coarse: number): Job<"picture"> {
    const { maps, weights, bend, view, style } = request;
    const options = {
      width: Math.ceil(request.width / coarse),
      height: Math.ceil(request.height / coarse),
      view: { ...view, scale: view.scale / coarse },
      colouring: style.colouring,
      palette: style.palette,
      lightGround: style.lightGround ?? false,
      ...(bend ? { bend } : {}),
    };
    const arrived = () => {
      if (coarse > 1 && request === this.#asked) this.#queue.request(() => this.#job(request, 1));
      else this.#arrived = request;
      this.#onArrival();
    };
    return single<"picture">(
      this.#channel,
      coarse > 1 ? 55 : 35,
      { kind: "picture", maps, weights, options },
      {
        accept: (bitmap) => {
          this.#paint(request, bitmap);
          arrived();
        },
        fail: arrived,
      },
    );
  }

  #paint({ width, height }: Request, bitmap: ImageBitmap): void {
    this.canvas.width = width;
    this.canvas.height = height;
    this.canvas.getContext("2d")?.drawImage(bitmap, 0, 0, width, height);
    bitmap.close();
  }

  async pixels(): Promise<Pixels> {
    const { width, height } = this.canvas;
    const image = this.canvas.getContext("2d")?.getImageData(0, 0, width, height);
    if (!image) throw new Error("There is no picture yet.");
    return { width, height, data: image.data };
  }

  free(): void {
    this.#sheet?.free();
    this.#sheet = null;
  }
}
