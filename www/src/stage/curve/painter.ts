import type { CurveMorph } from "#document/curve/curve";
import type { Photographs } from "#document/curve/photographs";
import { wordsOf } from "#document/notice";
import type { View } from "#geometry/coordinates";
import type { Bend } from "#wasm/api";
import type { RenderStyle } from "#wasm/core";
import { CanvasPainter } from "../surface/canvas-painter";
import type { PainterState } from "../surface/painter";
import { lookOf, paintCurve, paintInside } from "./paint";
import { Carried, type CarriedPicture } from "./photographs/carried";

/** What is to be seen. Sizes are device pixels, `view.scale` is in CSS pixels a unit. */
interface CurveRequest {
  morph: CurveMorph | null;
  s: number;
  bend: Bend | null;
  view: View;
  style: RenderStyle;
  /** Of both ends, where they are to be seen. */
  photographs: Photographs | null;
  width: number;
  height: number;
  /** Device pixels a CSS pixel. */
  ratio: number;
}

/** In device pixels: finer than the eye, or what a canvas shows. */
export const TOLERANCE = 0.35;
/** While things move and a frame takes longer than this, the next one is coarser. */
const LATE_MS = 14;
const SOON_MS = 6;
const COARSEST = 6;
/** Of the outline, in CSS pixels. */
const LINE_WIDTH = 1.8;
/** Vertices at most: more than a screen has room for. */
const MOST_VERTICES = 60_000;

/** The part of the plane that a picture shows, and a little more. */
export function windowOf({
  view,
  width,
  height,
  ratio,
}: Pick<CurveRequest, "view" | "width" | "height" | "ratio">) {
  const across = (0.55 * width) / (view.scale * ratio);
  const up = (0.55 * height) / (view.scale * ratio);
  return [view.x - across, view.y - up, view.x + across, view.y + up] as [number, number, number, number];
}

/** The bend, but for a mesh at rest, which bends nothing. */
export function moved(bend: Bend | null): Bend | null {
  return bend?.moves.some((x) => x !== 0) ? bend : null;
}

/** Keeps one canvas showing a closed curve: one polyline a frame, the latest wish wins. */
export class CurvePainter extends CanvasPainter {
  readonly #onBendProblem: (problem: string | null) => void;
  #wanted: CurveRequest | null = null;
  #drawn: CurveRequest | null = null;
  #frame = 0;
  /** How many times coarser than it should be the next frame is. */
  #coarse = 1;
  #fine = false;
  #carried: { morph: CurveMorph; photographs: Photographs; of: Carried } | null = null;

  constructor(
    host: HTMLElement,
    onState: (state: PainterState) => void,
    onBendProblem: (problem: string | null) => void,
  ) {
    super(host, onState);
    this.#onBendProblem = onBendProblem;
  }

  show(wanted: CurveRequest): void {
    this.#wanted = wanted;
    this.tell({ complete: false, settled: false });
    this.#schedule();
  }

  override close(): void {
    if (this.#frame) cancelAnimationFrame(this.#frame);
    super.close();
  }

  #schedule(): void {
    if (!this.#frame) this.#frame = requestAnimationFrame(() => this.#draw());
  }

  #draw(): void {
    this.#frame = 0;
    const wanted = this.#wanted;
    if (!wanted || wanted.width === 0 || wanted.height === 0) return;
    const still = wanted === this.#drawn;
    if (still && this.#fine) return;
    const coarse = still ? 1 : this.#coarse;
    const began = performance.now();
    const points = this.#paint(wanted, coarse);
    const took = performance.now() - began;
    if (took > LATE_MS) this.#coarse = Math.min(COARSEST, this.#coarse * 1.5);
    else if (took < SOON_MS) this.#coarse = Math.max(1, this.#coarse / 1.5);
    this.#drawn = wanted;
    this.#fine = coarse === 1;
    this.tell({ complete: this.#fine, settled: this.#fine, points });
    if (!this.#fine) this.#schedule();
  }

  /** How many vertices it has. */
  #paint(wanted: CurveRequest, coarse: number): number {
    const { morph, s, view, style, width, height, ratio } = wanted;
    const canvas = this.canvas;
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width;
      canvas.height = height;
    }
    const context = canvas.getContext("2d");
    if (!context || !morph) return 0;
    const scale = view.scale * ratio;
    const options = {
      tolerance: (coarse * TOLERANCE) / scale,
      window: windowOf(wanted),
      most: MOST_VERTICES,
    };
    let vertices: Float64Array;
    try {
      vertices = morph.polyline(s, { ...options, bend: moved(wanted.bend) });
      this.#onBendProblem(null);
    } catch (problem) {
      this.#onBendProblem(wordsOf(problem));
      vertices = morph.polyline(s, options);
    }
    const frame = { view: { ...view, scale }, width, height };
    const picture = this.#pictureOf(wanted, morph, coarse);
    if (picture) {
      paintInside(context, vertices, frame, picture);
      return vertices.length / 2;
    }
    paintCurve(
      context,
      vertices,
      frame,
      lookOf(morph, s, style.colouring, style.palette, LINE_WIDTH * ratio),
    );
    return vertices.length / 2;
  }

  /** What is to be seen inside the curve in place of colours. */
  #pictureOf(
    { photographs, bend, s }: CurveRequest,
    morph: CurveMorph,
    coarse: number,
  ): CarriedPicture | null {
    // Under a grid that is pulled the photographs would stay behind.
    if (!photographs || moved(bend)) return null;
    try {
      if (this.#carried?.morph !== morph || this.#carried.photographs !== photographs) {
        this.#carried = { morph, photographs, of: new Carried(morph, photographs) };
      }
      return this.#carried.of.at(s, coarse);
    } catch {
      // Without a canvas for them the curve is shown.
      return null;
    }
  }
}
