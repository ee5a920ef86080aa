import { wordsOf } from "#document/notice";
import type { View } from "#geometry/coordinates";
import type { RenderStyle } from "#wasm/core";
import { toError } from "#wasm/error";
import { directedTask } from "#workers/directed/client";
import type { Moment } from "#workers/directed/moment";
import { InTurn, isStopped } from "#workers/lanes/latest";
import { CanvasPainter } from "../surface/canvas-painter";
import type { PainterState } from "../surface/painter";
import { directedLook } from "./options";

/** What is to be seen. Sizes are device pixels, `view.scale` is in CSS pixels a unit. */
export interface DirectedRequest {
  moment: Moment;
  view: View;
  style: RenderStyle;
  width: number;
  height: number;
  /** Device pixels a CSS pixel. */
  ratio: number;
}

/** While a complete picture takes longer than this, one with fewer pixels a side comes first. */
const LATE_MS = 40;
const COARSEST = 6;

/** Keeps one canvas showing a graph-directed shape, which a worker draws: the latest wish wins, and none starves. */
export class DirectedPainter extends CanvasPainter {
  readonly #onProblem: (problem: string | null) => void;
  readonly #turn = new InTurn();
  readonly #end = new AbortController();
  #wanted: DirectedRequest | null = null;
  /** How many times coarser than it should be the first picture of a wish is. */
  #coarse = 2;

  constructor(
    host: HTMLElement,
    onState: (state: PainterState) => void,
    onProblem: (problem: string | null) => void,
  ) {
    super(host, onState);
    this.#onProblem = onProblem;
  }

  show(wanted: DirectedRequest): void {
    this.#wanted = wanted;
    this.tell({ complete: false, settled: false });
    this.#turn.ask(() => this.#draw(wanted));
  }

  override close(): void {
    this.#turn.clear();
    this.#end.abort();
    super.close();
  }

  /** Coarse where that is needed, then complete, unless something else is wanted by then. */
  async #draw(wanted: DirectedRequest): Promise<void> {
    try {
      if (this.#coarse > 1) await this.#paint(wanted, this.#coarse);
      if (wanted !== this.#wanted || this.#end.signal.aborted) return;
      const began = performance.now();
      await this.#paint(wanted, 1);
      const slow = Math.sqrt((performance.now() - began) / LATE_MS);
      this.#coarse = slow < 1 ? 1 : Math.min(COARSEST, Math.ceil(slow) + 1);
      this.#onProblem(null);
      if (wanted === this.#wanted) this.tell({ complete: true, settled: true, empty: false });
    } catch (problem) {
      if (isStopped(problem)) return;
      const { code } = toError(problem);
      // Maps that do not contract leave nothing to be seen; of all else what was there stays.
      const empty = code === "no-attractor" || code === "attractor-unproved";
      this.canvas.style.visibility = empty ? "hidden" : "visible";
      this.#onProblem(wordsOf(problem));
      if (wanted === this.#wanted) this.tell({ complete: true, settled: true, empty });
    }
  }

  async #paint(wanted: DirectedRequest, coarse: number): Promise<void> {
    const { moment, view, style, ratio } = wanted;
    const [width, height] = [wanted.width, wanted.height].map((side) =>
      Math.max(1, Math.ceil(side / coarse)),
    ) as [number, number];
    const options = {
      width,
      height,
      view: { ...view, scale: (view.scale * ratio) / coarse },
      ...directedLook(style.colouring, style.palette),
      smooth: coarse === 1,
    };
    const bitmap = await directedTask("moment", { moment, options }, { signal: this.#end.signal });
    const canvas = this.canvas;
    canvas.width = wanted.width;
    canvas.height = wanted.height;
    canvas.getContext("2d")?.drawImage(bitmap, 0, 0, wanted.width, wanted.height);
    canvas.style.visibility = "visible";
    bitmap.close();
  }
}
