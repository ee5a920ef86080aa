/** Proofs for the samples of a whole locus that hold as far as can be seen, in small rectangles. */
import { STATE } from "#geometry/states";
import type { Job, Task } from "#workers/pool/protocol";
import { type LocusWork, nextKey, patchesOf, type Rectangle, SIZE } from "./job";

/** Samples along a side: a few hundredths of a second. */
const SIDE = 16;
/** Whatever else there is to do goes first. */
const PRIORITY = 1;
/** Milliseconds of all workers together: what takes longer, shapes of many maps that hardly cross, costs a battery. */
const MOST_MS = 30_000;

/** What is proved of a locus that is whole. */
export class LocusProofs {
  readonly #work: LocusWork;
  readonly #painted: () => void;
  readonly #key = nextKey();
  readonly #open: Rectangle[];
  #left: number;
  #spent = 0;

  constructor(work: LocusWork, painted: () => void) {
    this.#work = work;
    this.#painted = painted;
    this.#open = patchesOf(SIZE, SIDE).filter((rectangle) =>
      work.statesOf(rectangle).includes(STATE.touching),
    );
    this.#left = this.#open.length;
  }

  get done(): boolean {
    return this.#left === 0;
  }

  job(): Job<"prove"> {
    return {
      channel: "proofs",
      priority: () => PRIORITY,
      next: () => this.#next(),
      accept: (task, states, milliseconds) => {
        this.#work.prove(task, states);
        this.#spent += milliseconds;
        if (this.#spent > MOST_MS) this.#left -= this.#open.splice(0).length;
        this.#tell();
      },
      // What is not proved stays as it was.
      fail: () => this.#tell(),
    };
  }

  #next(): Task<"prove"> | null {
    const rectangle = this.#open.shift();
    if (!rectangle) return null;
    const state = this.#work.statesOf(rectangle);
    return { kind: "prove", key: this.#key, of: this.#work.whole(), ...rectangle, state };
  }

  #tell(): void {
    this.#left--;
    this.#painted();
  }
}
