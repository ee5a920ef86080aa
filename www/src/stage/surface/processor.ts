import type { Photograph } from "#document/deform/photograph";
import type { View } from "#geometry/coordinates";
import type { Bend, MapRow, RasterOptions } from "#wasm/api";
import { bends, bendsFor, bendsReady, loadBends } from "#wasm/bend";
import { frond, type RenderStyle } from "#wasm/core";
import { frameTask } from "#workers/frames/client";
import type { Frame } from "#workers/frames/tasks";
import * as messages from "../messages";
import { FrameQueue, type Quality } from "./frame-queue";
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
  /** Device pixels for each of CSS. */
  ratio: number;
}

const LANES = 2;
/** A frame of what moves is to take about so long: where device pixels take longer, it has those of CSS. */
const FRAME_MS = 12;

/** Fills the canvas with pixels that workers compute: each frame whole while things move, complete when all rests. */
export class Processor implements Surface {
  readonly canvas: HTMLCanvasElement;
  readonly #queue: FrameQueue<Request, Frame>;
  #wanted: Partial<Request> = {};
  #sheet: SheetPainter | null = null;
  #asked: Request | null = null;
  /** Pixels of a frame of what moves, for each of the canvas and side. */
  #share = 1;
  /** How long the last frame of what moves took to draw. */
  milliseconds = Number.POSITIVE_INFINITY;

  constructor(canvas: HTMLCanvasElement, onArrival: () => void) {
    this.canvas = canvas;
    this.#queue = new FrameQueue({
      lanes: LANES,
      draw: (request, quality, lane) => this.#draw(request, quality, lane as 0 | 1),
      show: (frame, request, quality) => {
        if (frame) this.#paint(request, frame, quality);
        onArrival();
      },
      drop: ({ image }) => image.close(),
    });
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
    this.#wanted = { ...this.#wanted, view: { ...view, scale: view.scale * ratio }, ratio };
  }

  setStyle(style: RenderStyle): void {
    this.#wanted = { ...this.#wanted, style };
  }

  resize(width: number, height: number): void {
    this.#wanted = { ...this.#wanted, width, height };
    this.#share = 1;
  }

  draw(_budget: number): Drawn {
    const { maps, weights, bend = null, view, style, width, height, ratio = 1 } = this.#wanted;
    if (!maps || !view || !style || !width || !height) return { complete: true, settled: true, points: 0 };
    if (this.#sheet) {
      return this.#sheet.draw(this.canvas, { bend, parts: partsOf(maps), view, width, height });
    }
    const asked = this.#asked;
    const request: Request = { maps, weights, bend, view, style, width, height, ratio };
    if (!asked || KEYS.some((key) => asked[key] !== request[key])) {
      this.#asked = request;
      this.#queue.ask(request);
    }
    const { complete } = this.#queue;
    return { complete, settled: complete, points: 0, whole: this.milliseconds < Number.POSITIVE_INFINITY };
  }

  async #draw(request: Request, quality: Quality, lane: 0 | 1): Promise<Frame> {
    const { maps, weights, bend, view, style } = request;
    const moving = quality === "moving";
    const share = moving ? Math.max(this.#share, 1 / request.ratio) : 1;
    const options: RasterOptions = {
      width: Math.ceil(request.width * share),
      height: Math.ceil(request.height * share),
      view: { ...view, scale: view.scale * share },
      colouring: style.colouring,
      palette: style.palette,
      lightGround: style.lightGround ?? false,
      draft: moving,
      ...(bend ? { bend } : {}),
    };
    return frameTask("frame", { maps, weights, options, bends: await bendsFor(options) }, { lane });
  }

  #paint({ width, height, ratio }: Request, { image, milliseconds }: Frame, quality: Quality): void {
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
    const context = this.canvas.getContext("2d");
    context?.clearRect(0, 0, width, height);
    context?.drawImage(image, 0, 0, width, height);
    image.close();
    if (quality === "moving") this.milliseconds = milliseconds;
    // As many pixels as there is time for, between those of CSS and those of the device.
    if (quality === "moving" && ratio > 1) {
      const next = this.#share * Math.sqrt(FRAME_MS / Math.max(1, milliseconds));
      this.#share = Math.min(1, Math.max(1 / ratio, 0.75 * this.#share + 0.25 * next));
    }
  }

  async pixels(): Promise<Pixels> {
    const { width, height } = this.canvas;
    const image = this.canvas.getContext("2d")?.getImageData(0, 0, width, height);
    if (!image) throw new Error(messages.thereNoPictureYet);
    return { width, height, data: image.data };
  }

  free(): void {
    this.#queue.close();
    this.#sheet?.free();
    this.#sheet = null;
  }
}
