/** A card that takes longer for a frame of what moves, or draws fewer points in it, leaves the picture coarse. */
const LATE_MS = 25;
const FEW_POINTS = 300_000;
/** So many frames are looked at. */
const FRAMES = 12;
/** A change is worth while where frames come sooner by this factor. */
const SOONER = 0.7;
const TRIES = 4;
/** After so many frames a processor that was slower, maybe since it had other things to do, is tried again. */
const AGAIN = 600;
const EVERY_FRAME_MS = 1000 / 60;

/**
 * Measures how a graphics card does with what moves. The processor draws every frame whole, so that it takes over where
 * its frames come sooner than those of a card that is late, or in time where those of the card are coarse.
 */
export class CardClock {
  #frames: number[] = [];
  #points = Number.POSITIVE_INFINITY;
  #tries = 0;
  /** Frames since the processor was tried. */
  #since = 0;

  /** The picture has another size. */
  reset(): void {
    this.#frames = [];
    this.#tries = 0;
    this.#since = 0;
  }

  /**
   * Notes a frame: how long after it was asked for it came, and its points. True when that is late or little, and not
   * again for some time.
   */
  isLate(milliseconds: number, points: number): boolean {
    if (this.#tries > 0) {
      if (++this.#since < AGAIN) return false;
      this.reset();
    }
    this.#frames.push(milliseconds);
    this.#points = points;
    if (this.#frames.length < FRAMES) return false;
    const late = this.#median > LATE_MS || points < FEW_POINTS;
    if (late) this.#tries = 1;
    this.#frames.shift();
    return late;
  }

  /** Whether a processor that takes so long for a frame is better. */
  isSlowerThan(milliseconds: number): boolean {
    if (milliseconds < SOONER * this.#median) return true;
    return this.#points < FEW_POINTS && milliseconds <= EVERY_FRAME_MS;
  }

  /** Takes one of the tries of the processor; whether there was one. */
  takeTry(): boolean {
    return this.#tries++ < TRIES;
  }

  get #median(): number {
    const sorted = [...this.#frames].sort((a, b) => a - b);
    return sorted[sorted.length >> 1] ?? 0;
  }
}
