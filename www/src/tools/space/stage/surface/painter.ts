import { notify, wordsOf } from "#document/notice";
import type { PainterBackend } from "#stage/surface/painter";
import type { Pixels } from "#stage/surface/surface";
import * as messages from "../../messages";
import { openSurface } from "./open";
import type { Surface, Wanted } from "./surface";

export interface Painted {
  backend: PainterBackend | null;
  /** What is shown is the complete picture. */
  complete: boolean;
  /** It is as smooth as it gets, and nothing is being made. */
  settled: boolean;
  /** Points in the picture that is shown; 0 where it is the complete one. */
  points: number;
  /** The complete picture has not a pixel lit. */
  empty: boolean;
  /** Why there is no such view, in words. */
  problem: string | null;
}

export const NOTHING: Painted = {
  backend: null,
  complete: false,
  settled: false,
  points: 0,
  empty: false,
  problem: null,
};

/** The complete picture is begun when nothing has changed for so long. */
const REST_MS = 120;
/** Losses within this time count together; after so many the graphics device is not tried again. */
const PATIENCE_MS = 30_000;
const MOST_LOSSES = 3;

/**
 * Keeps one canvas showing space, and draws only when there is something new to draw: what can be had at once while
 * things move, the complete picture when they rest. A lost device costs a new canvas and a new renderer.
 */
export class SpacePainter {
  readonly #host: HTMLElement;
  readonly #backend: "auto" | PainterBackend;
  readonly #onState: (state: Painted) => void;
  #surface: Surface | null = null;
  #wanted: Wanted | null = null;
  #drawn: Wanted | null = null;
  #state: Painted = NOTHING;
  #frame = 0;
  #rest: ReturnType<typeof setTimeout> | null = null;
  #completing: AbortController | null = null;
  #losses: number[] = [];
  #closed = false;

  constructor(
    host: HTMLElement,
    options: { backend: "auto" | PainterBackend; onState: (state: Painted) => void },
  ) {
    this.#host = host;
    this.#backend = options.backend;
    this.#onState = options.onState;
    void this.#open();
  }

  show(wanted: Wanted): void {
    this.#wanted = wanted;
    if (!this.#drawn || !this.#surface?.keeps(this.#drawn, wanted)) {
      // At once: what is being made is made of things that may be gone by the next frame.
      this.#callOff();
      this.#set({ complete: false, settled: false });
    }
    this.#schedule();
  }

  async pixels(): Promise<Pixels> {
    if (!this.#surface) throw new Error(messages.thereNoPictureYet);
    return this.#surface.pixels();
  }

  objectAt(x: number, y: number): number | null {
    return this.#surface?.objectAt(x, y) ?? null;
  }

  forceLoss(): void {
    this.#surface?.forceLoss();
  }

  close(): void {
    this.#closed = true;
    cancelAnimationFrame(this.#frame);
    this.#callOff();
    this.#surface?.free();
    this.#surface?.canvas.remove();
  }

  async #open(): Promise<void> {
    const recent = this.#losses.filter((at) => performance.now() - at < PATIENCE_MS);
    let mine: Surface | null = null;
    mine = await openSurface(
      recent.length < MOST_LOSSES ? this.#backend : "canvas",
      (reason) => mine && this.#lost(mine, reason),
    );
    if (this.#closed) {
      mine.free();
      return;
    }
    for (const old of this.#host.querySelectorAll("canvas")) old.remove();
    this.#host.prepend(mine.canvas);
    this.#surface = mine;
    this.#drawn = null;
    this.#set({ backend: mine.backend });
    this.#schedule();
  }

  #lost(surface: Surface, reason: string): void {
    if (this.#closed || surface !== this.#surface) return;
    this.#losses.push(performance.now());
    this.#surface = null;
    this.#callOff();
    this.#set({ complete: false, settled: false });
    void this.#open().then(() => {
      notify({
        kind: "info",
        text: messages.deviceLost(reason),
      });
      // Freed after its successor stands: its canvas shows the last picture until then.
      surface.free();
    });
  }

  #schedule(): void {
    if (this.#frame || this.#closed || !this.#surface || !this.#wanted) return;
    const asked = performance.now();
    this.#frame = requestAnimationFrame(() => this.#draw(performance.now() - asked));
  }

  #draw(waited: number): void {
    this.#frame = 0;
    const surface = this.#surface;
    const wanted = this.#wanted;
    if (!surface || !wanted || wanted.width === 0 || wanted.height === 0) return;
    try {
      const { points } = surface.draw(wanted, waited);
      this.#drawn = wanted;
      this.#set({ points, problem: null });
    } catch (problem) {
      this.#drawn = null;
      this.#callOff();
      this.#set({ problem: wordsOf(problem), complete: false, settled: false });
      return;
    }
    if (this.#state.settled || this.#rest || this.#completing) return;
    this.#rest = setTimeout(() => void this.#complete(surface), REST_MS);
  }

  async #complete(surface: Surface): Promise<void> {
    this.#rest = null;
    const wanted = this.#drawn;
    if (!wanted) return;
    const call = new AbortController();
    this.#completing = call;
    try {
      await surface.complete(wanted, call.signal, ({ empty }) => {
        if (this.#completing === call) this.#set({ complete: true, points: 0, empty });
      });
      if (this.#completing === call) this.#set({ settled: true });
    } catch (problem) {
      if (call.signal.aborted || this.#closed) return;
      notify({ kind: "error", text: messages.notComplete(wordsOf(problem)) });
    } finally {
      if (this.#completing === call) this.#completing = null;
    }
  }

  #callOff(): void {
    if (this.#rest) clearTimeout(this.#rest);
    this.#rest = null;
    this.#completing?.abort();
    this.#completing = null;
  }

  #set(change: Partial<Painted>): void {
    this.#state = { ...this.#state, ...change };
    this.#onState(this.#state);
  }
}
