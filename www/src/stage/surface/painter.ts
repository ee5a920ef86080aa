import { notify, wordsOf } from "#document/notice";
import type { Bend } from "#wasm/api";
import { type Backend, createRenderer, type Renderer } from "#wasm/renderer";
import { drawsInSoftware } from "#wasm/webgpu";
import * as messages from "../messages";
import { Accelerated } from "./accelerated";
import { CardClock } from "./card-clock";
import { explainMissing } from "./missing";
import { Preview } from "./preview";
import type { Processor } from "./processor";
import type { Pixels, Surface, Wanted } from "./surface";

export type PainterBackend = Backend | "canvas";

export interface PainterState {
  backend: PainterBackend | null;
  /** Every pixel that holds a piece of the attractor is lit. */
  complete: boolean;
  /** What is shown is as good as it gets, and nothing is being drawn. */
  settled: boolean;
  points: number;
  /** The maps have no attractor, so there is nothing to see. */
  empty: boolean;
  /** A coarse picture stands in until the renderer is there. */
  preview: boolean;
}

/** Before anything is drawn. */
export const UNSEEN: PainterState = {
  backend: null,
  complete: false,
  settled: false,
  points: 0,
  empty: false,
  preview: false,
};

/** What is asked of whatever draws the main picture. */
export type MainPainter = Pick<Painter, "pixels" | "forceLoss">;

interface PainterOptions {
  backend: "auto" | PainterBackend;
  onState: (state: PainterState) => void;
  /** A bend that cannot be had, in words, or null once one can. */
  onBendProblem?: (problem: string | null) => void;
}

/** Losses within this time count together; after so many the graphics device is not tried again. */
const PATIENCE_MS = 30_000;
const MOST_LOSSES = 3;
/** A renderer that takes longer than this to complete its first picture shows how far it is. */
const PREVIEW_MS = 3000;
const LEAST_BUDGET = 20_000;
const MOST_BUDGET = 8_000_000;
const SOON_MS = 18;
const LATE_MS = 30;

/** What draws without a card: not before it is known that none draws, or that it is late. */
const loadProcessor = (): Promise<{ Processor: typeof Processor }> => import("./processor");

/**
 * Keeps one canvas showing what it is told to, and draws only when there is something new to draw. A lost device costs
 * a new canvas and a new renderer; one that cannot be had at all is replaced by pixels computed without it.
 */
export class Painter {
  readonly #host: HTMLElement;
  readonly #options: PainterOptions;
  #surface: Surface | null = null;
  #renderer: Renderer | null = null;
  #canvas: HTMLCanvasElement | null = null;
  #wanted: Wanted | null = null;
  #given: Partial<Wanted> = {};
  #empty = false;
  /** Until the first surface has drawn. */
  #preview: Preview | null;
  #deadline = Number.POSITIVE_INFINITY;
  #state = UNSEEN;
  #frame = 0;
  #budget = 200_000;
  /** Tells when the processor is to be tried in place of the card. */
  #clock = new CardClock();
  /** The processor, while it is tried. */
  #trial: Surface | null = null;
  #asked = 0;
  #losses: number[] = [];
  #closed = false;

  constructor(host: HTMLElement, options: PainterOptions) {
    this.#host = host;
    this.#options = options;
    this.#preview = new Preview(host, () => {
      if (this.#wanted) this.show(this.#wanted);
    });
    void this.#open();
  }

  show(wanted: Wanted): void {
    this.#wanted = wanted;
    this.#set({ complete: false, settled: false });
    if (this.#preview) this.#set({ preview: this.#preview.show(wanted) });
    this.#schedule();
  }

  async pixels(): Promise<Pixels> {
    if (!this.#surface) throw new Error(messages.thereNoPictureYet);
    return this.#surface.pixels();
  }

  forceLoss(): void {
    this.#renderer?.forceLoss();
  }

  get backend(): PainterBackend | null {
    return this.#state.backend;
  }

  close(): void {
    this.#closed = true;
    if (this.#frame) cancelAnimationFrame(this.#frame);
    this.#surface?.free();
    this.#endTrial();
    this.#canvas?.remove();
    this.#preview?.close();
  }

  async #open(): Promise<void> {
    const canvas = document.createElement("canvas");
    canvas.setAttribute("aria-hidden", "true");
    const recent = this.#losses.filter((at) => performance.now() - at < PATIENCE_MS);
    let surface: Surface | null = null;
    const { backend } = this.#options;
    // What stands in for a card is the processor too, and slower at it.
    const software = backend === "auto" && (await drawsInSoftware());
    if (backend !== "canvas" && !software && recent.length < MOST_LOSSES) {
      try {
        let mine: Renderer | null = null;
        const onLost = (reason: string) => mine && this.#lost(mine, reason);
        mine = await createRenderer(canvas, { backend, onLost });
        this.#renderer = mine;
        surface = new Accelerated(mine, canvas);
        this.#set({ backend: mine.backend });
      } catch (problem) {
        explainMissing(problem);
      }
    }
    if (!surface) {
      this.#renderer = null;
      // A canvas that has had one kind of context gives no other.
      const fresh = canvas.cloneNode() as HTMLCanvasElement;
      const { Processor } = await loadProcessor();
      surface = new Processor(fresh, () => this.#schedule());
      this.#set({ backend: "canvas" });
    }
    if (this.#closed) {
      surface.free();
      return;
    }
    this.#canvas?.remove();
    this.#canvas = surface.canvas;
    if (this.#preview) {
      surface.canvas.style.opacity = "0";
      this.#deadline = performance.now() + PREVIEW_MS;
    }
    this.#host.prepend(surface.canvas);
    this.#surface = surface;
    this.#given = {};
    this.#schedule();
  }

  #endPreview(): void {
    this.#preview?.close();
    this.#preview = null;
    if (this.#canvas) this.#canvas.style.opacity = "";
  }

  #lost(renderer: Renderer, reason: string): void {
    if (this.#closed || renderer !== this.#renderer) return;
    this.#losses.push(performance.now());
    this.#renderer = null;
    this.#surface = null;
    this.#set({ complete: false, settled: false });
    void this.#open().then(() => {
      notify({
        kind: "info",
        text: messages.deviceLost(reason),
      });
      // Freed after its successor stands: its canvas shows the last picture until then.
      try {
        renderer.free();
      } catch {
        // A device that is gone may refuse to be let go.
      }
    });
  }

  #schedule(): void {
    if (this.#frame || this.#closed || !this.#surface || !this.#wanted) return;
    this.#asked = performance.now();
    this.#frame = requestAnimationFrame(() => this.#draw());
  }

  #draw(): void {
    this.#frame = 0;
    const surface = this.#surface;
    if (!surface || !this.#wanted || this.#wanted.width === 0 || this.#wanted.height === 0) return;
    const late = surface.lacks?.(this.#wanted);
    if (late) {
      // Where it cannot be had, whoever has the document says so.
      late.then(
        () => this.#schedule(),
        () => {},
      );
      return;
    }
    const waited = performance.now() - this.#asked;
    this.#adapt(waited);
    this.#watch(surface, waited);
    this.#give(surface, this.#wanted);
    if (this.#empty) {
      this.#set({ complete: true, settled: true, points: 0, empty: true });
      this.#endPreview();
      return;
    }
    const { complete, settled, points, whole = complete } = surface.draw(this.#budget);
    // A picture is no cloud of points: what its renderer counts are triangles.
    this.#set({ complete, settled, points: this.#wanted.picture ? 0 : points, empty: false });
    // A renderer begins coarser than the preview is.
    if (whole || (points > 0 && performance.now() > this.#deadline)) this.#endPreview();
    if (!settled) this.#schedule();
  }

  /** More points a frame while frames come soon after they are asked for, fewer when one is late. */
  #adapt(waited: number): void {
    if (waited > LATE_MS)
      this.#budget = Math.max(LEAST_BUDGET, this.#budget * (waited > 3 * LATE_MS ? 0.4 : 0.7));
    else if (waited < SOON_MS) this.#budget = Math.min(MOST_BUDGET, this.#budget * 1.15);
  }

  /** Where the card is late with what moves, and the processor draws it sooner, the processor takes over. */
  #watch(surface: Surface, waited: number): void {
    const [wanted, given] = [this.#wanted, this.#given];
    if (this.#options.backend !== "auto" || !(surface instanceof Accelerated) || !wanted) return;
    if (wanted.bend || wanted.picture || wanted.style.colouring === "density") return;
    if (wanted.width !== given.width || wanted.height !== given.height) this.#clock.reset();
    if (wanted.maps === given.maps && wanted.view === given.view) return;
    if (this.#clock.isLate(waited, this.#budget)) void this.#try(surface);
  }

  async #try(surface: Surface): Promise<void> {
    const { Processor } = await loadProcessor();
    const wanted = this.#wanted;
    if (this.#surface !== surface || this.#closed || !wanted) return;
    const fresh = document.createElement("canvas");
    fresh.setAttribute("aria-hidden", "true");
    const next = new Processor(fresh, () => {
      if (this.#surface === next) this.#schedule();
      else if (this.#surface === surface && this.#clock.isSlowerThan(next.milliseconds))
        this.#replace(surface, next);
      // The first frames of a worker take longer: it is compiled meanwhile.
      else if (this.#surface === surface && this.#clock.takeTry() && this.#wanted)
        this.#ask(next, this.#wanted);
      else this.#endTrial();
    });
    this.#endTrial();
    this.#trial = next;
    this.#ask(next, wanted);
  }

  #endTrial(): void {
    this.#trial?.free();
    this.#trial = null;
  }

  #ask(surface: Surface, wanted: Wanted): void {
    try {
      this.#give(surface, wanted, {});
      surface.draw(0);
    } catch {
      this.#endTrial();
    }
  }

  /** The other surface has drawn: it takes the place of this one, whose picture it shows as well. */
  #replace(surface: Surface, next: Surface): void {
    this.#trial = null;
    this.#host.prepend(next.canvas);
    this.#canvas?.remove();
    this.#canvas = next.canvas;
    this.#surface = next;
    this.#renderer = null;
    this.#given = {};
    surface.free();
    this.#set({ backend: "canvas" });
    this.#schedule();
  }

  #give(surface: Surface, wanted: Wanted, given = this.#given): void {
    if (wanted.width !== given.width || wanted.height !== given.height) {
      surface.resize(wanted.width, wanted.height);
    }
    if (wanted.style !== given.style) surface.setStyle(wanted.style);
    if (wanted.maps !== given.maps || wanted.weights !== given.weights) {
      try {
        surface.setMaps(wanted.maps, wanted.weights);
        this.#empty = false;
      } catch {
        this.#empty = true;
      }
      if (this.#canvas) this.#canvas.style.visibility = this.#empty ? "hidden" : "visible";
    }
    if (wanted.picture !== (given.picture ?? null)) surface.setPicture(wanted.picture);
    if (wanted.bend !== given.bend) this.#bend(surface, wanted.bend);
    if (wanted.view !== given.view || wanted.ratio !== given.ratio || wanted.maps !== given.maps) {
      surface.setView(wanted.view, wanted.ratio);
    }
    if (surface === this.#surface) this.#given = wanted;
  }

  #bend(surface: Surface, bend: Bend | null): void {
    let problem: string | null = null;
    try {
      surface.setBend(bend);
    } catch (cause) {
      problem = wordsOf(cause);
    }
    this.#options.onBendProblem?.(problem);
  }

  #set(change: Partial<PainterState>): void {
    this.#state = { ...this.#state, ...change };
    this.#options.onState(this.#state);
  }
}
