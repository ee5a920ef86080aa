/** What a timer shows. */

/** A lesson is shorter. */
export const MOST_MINUTES = 90;

/** Whole seconds that are left, of so many milliseconds, when it runs since a moment or stands. */
export function secondsLeft(left: number, since: number | null, now: number): number {
  return Math.ceil(Math.max(0, left - (since === null ? 0 : now - since)) / 1000);
}

/** As a clock has it: `3:00`. */
export function clockWords(seconds: number): string {
  return `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, "0")}`;
}
