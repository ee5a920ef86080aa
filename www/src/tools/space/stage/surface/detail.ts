/** How much is drawn while something moves, so that frames come in time. Pure. */

interface Level {
  points: number;
  /** So many pixels of the stage are one of the picture, each way. */
  shrink: number;
}

/** From a graphics card to a processor that stands in for one. */
export const LEVELS: readonly Level[] = [
  { points: 1_000_000, shrink: 1 },
  { points: 500_000, shrink: 1 },
  { points: 250_000, shrink: 1 },
  { points: 250_000, shrink: 2 },
  { points: 120_000, shrink: 3 },
  { points: 60_000, shrink: 4 },
];
/** Where a phone begins. */
export const HANDHELD = 1;

const LATE_MS = 42;
const VERY_LATE_MS = 200;
const SOON_MS = 20;
/** So many late frames, and there is less to draw; so many in a row that come soon, and there is more. */
const PATIENCE = 3;
const TRUST = 90;

/** Goes by how long frames are waited for. */
export class Detail {
  readonly #best: number;
  #level: number;
  #late = 0;
  #soon = 0;

  constructor(best = 0) {
    this.#best = best;
    this.#level = best;
  }

  get level(): Level {
    return LEVELS[this.#level] as Level;
  }

  /** A frame that belongs to a movement came so many milliseconds after it was asked for. */
  frame(waited: number): void {
    this.#soon = waited < SOON_MS ? this.#soon + 1 : 0;
    if (waited > VERY_LATE_MS) this.#late += PATIENCE;
    else this.#late = waited > LATE_MS ? this.#late + 1 : 0;
    if (this.#late >= PATIENCE) {
      // A processor in the place of a graphics card is not found out step by step.
      this.#level = Math.min(LEVELS.length - 1, this.#level + (waited > VERY_LATE_MS ? 2 : 1));
      this.#late = 0;
    } else if (this.#soon >= TRUST) {
      this.#level = Math.max(this.#best, this.#level - 1);
      this.#soon = 0;
    }
  }
}
