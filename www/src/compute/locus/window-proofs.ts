/** Proofs for the samples of a window that hold as far as can be seen, in small rectangles, the middle first. */
import type { LocusView } from "#wasm/api";
import type { Job, Task } from "#workers/pool/protocol";
import type { Part } from "./pyramid";
import { windowOf } from "./window";
import type { WindowWork } from "./window-job";

/** Samples along a side: a few hundredths of a second. */
const SIDE = 16;
/** What is seen goes before the whole plane, and all else before either. */
const PRIORITY = 2;
/** Milliseconds of all workers together: what takes longer costs a battery. */
const MOST_MS = 60_000;

export class WindowProofs {
  readonly #work: WindowWork;
  readonly #painted: () => void;
  readonly #open: Part[];
  readonly #parts = new WeakMap<object, Part>();
  /** A tile is prepared once for all of its parts. */
  #grid: { tile: string; of: ReturnType<WindowWork["gridOf"]> } | null = null;
  #left: number;
  #spent = 0;

  constructor(work: WindowWork, view: LocusView, detail: number, painted: () => void) {
    this.#work = work;
    this.#painted = painted;
    this.#open = work.pyramid.unproved(windowOf(view), view.zoom * detail, SIDE);
    this.#left = this.#open.length;
  }

  get done(): boolean {
    return this.#left === 0;
  }

  job(): Job<"prove"> {
    return {
      channel: "window-proofs",
      priority: () => PRIORITY,
      next: () => this.#next(),
      accept: (task, states, milliseconds) => {
        const part = this.#parts.get(task);
        if (part) this.#work.pyramid.prove(part, states);
        this.#spent += milliseconds;
        if (this.#spent > MOST_MS) this.#left -= this.#open.splice(0).length;
        this.#tell();
      },
      // What is not proved stays as it was.
      fail: () => this.#tell(),
    };
  }

  #next(): Task<"prove"> | null {
    const part = this.#open.shift();
    if (!part) return null;
    const { level, i, j } = part.id;
    const tile = `${level}/${i}/${j}`;
    if (this.#grid?.tile !== tile) this.#grid = { tile, of: this.#work.gridOf(part.id) };
    const { key, of, x0, y0 } = this.#grid.of;
    const task: Task<"prove"> = {
      kind: "prove",
      key,
      of,
      x0: x0 + part.x0,
      y0: y0 + part.y0,
      x1: x0 + part.x1,
      y1: y0 + part.y1,
      state: this.#work.pyramid.statesOf(part),
    };
    this.#parts.set(task, part);
    return task;
  }

  #tell(): void {
    this.#left--;
    this.#painted();
  }
}
