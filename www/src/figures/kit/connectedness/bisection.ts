/** Finds where a question that is answered no below and yes above turns, one answer at a time. */
export class Bisection {
  low: number;
  high: number;
  asked = 0;
  readonly #width: number;

  constructor(low: number, high: number, width: number) {
    this.low = low;
    this.high = high;
    this.#width = width;
  }

  get done(): boolean {
    return this.high - this.low <= this.#width;
  }

  /** Where to ask next. */
  get middle(): number {
    return (this.low + this.high) / 2;
  }

  tell(at: number, yes: boolean): void {
    this.asked++;
    if (yes) this.high = Math.min(this.high, at);
    else this.low = Math.max(this.low, at);
  }

  /** How many answers it takes in all. */
  static answers(low: number, high: number, width: number): number {
    return Math.max(0, Math.ceil(Math.log2((high - low) / width) - 1e-9));
  }
}

/** The value in the middle of a list; the lower of two. NaN for none. */
export function median(values: readonly number[]): number {
  const sorted = [...values].sort((p, q) => p - q);
  return sorted[Math.floor((sorted.length - 1) / 2)] ?? Number.NaN;
}
