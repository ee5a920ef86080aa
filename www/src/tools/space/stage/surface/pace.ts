/** How many pixels a picture has that is carved while something moves, so that frames come in time. Pure. */

/** So many pixels of the stage are one of the picture, each way. */
export const SHRINKS = [1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 12] as const;
/** Fewer pixels do not come sooner, whatever keeps them. */
const FEWEST_PIXELS = 24_000;
/** Where a movement begins, before anything was measured. */
const FIRST = SHRINKS.indexOf(3);

/** What a frame is to take, in milliseconds, and what it may. */
const AIM_MS = 33;
const LATE_MS = 40;
/** So many frames in a row are to say that there is time for more pixels. */
const PATIENCE = 6;

/** Goes by how long frames take. */
export class Pace {
  #at: number = FIRST;
  /** The coarsest that there is to be. */
  #most = SHRINKS.length - 1;
  #soon = 0;

  /** The stage has so many pixels. */
  stage(pixels: number): void {
    const coarser = SHRINKS.findIndex((shrink) => pixels < FEWEST_PIXELS * shrink ** 2);
    this.#most = coarser < 0 ? SHRINKS.length - 1 : Math.max(0, coarser - 1);
    this.#at = Math.min(this.#at, this.#most);
  }

  get shrink(): number {
    return SHRINKS[this.#at] as number;
  }

  /** A frame with this `shrink` took so many milliseconds. */
  frame(milliseconds: number, shrink = this.shrink): void {
    // What was asked for before the last change says nothing of what is asked for now.
    if (shrink !== this.shrink || !(milliseconds >= 0)) return;
    if (milliseconds > LATE_MS) {
      this.#soon = 0;
      this.#at = Math.max(this.#at + 1, this.#fitting(milliseconds));
      this.#at = Math.min(this.#at, this.#most);
      return;
    }
    const finer = SHRINKS[this.#at - 1];
    const there = finer !== undefined && expected(milliseconds, shrink, finer) <= AIM_MS;
    this.#soon = there ? this.#soon + 1 : 0;
    if (this.#soon < PATIENCE) return;
    this.#soon = 0;
    this.#at--;
  }

  /** The finest that should come in time. */
  #fitting(milliseconds: number): number {
    const found = SHRINKS.findIndex((other) => expected(milliseconds, this.shrink, other) <= AIM_MS);
    return found < 0 ? SHRINKS.length - 1 : found;
  }
}

/** Work goes by pixels. */
function expected(milliseconds: number, shrink: number, other: number): number {
  return milliseconds * (shrink / other) ** 2;
}
