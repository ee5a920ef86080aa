/** How much of a path is broken, in numbers and in words. */

import { fixed } from "#format/numbers";
import { isBroken, STATE, type Stretch, stretches } from "#geometry/states";

export interface Breakage {
  stretches: Stretch[];
  /** Parts of the samples that are broken: of all, and of the first and the second half. */
  share: number;
  halves: [number, number];
  /** How many are proved to be in pieces by a gap that is not seen. */
  hidden: number;
}

export function breakage(states: ArrayLike<number>): Breakage {
  const broken = Array.from(states, isBroken);
  const part = (from: number, to: number) =>
    to > from ? broken.slice(from, to).filter(Boolean).length / (to - from) : 0;
  const middle = Math.floor(broken.length / 2);
  return {
    stretches: stretches(states),
    share: part(0, broken.length),
    halves: [part(0, middle), part(broken.length - middle, broken.length)],
    hidden: Array.from(states).filter((state) => state === STATE.hidden).length,
  };
}

/** "84%"; never all or nothing by rounding. */
export function shareWords(share: number): string {
  if (share === 0) return "none";
  if (share === 1) return "all";
  return `${Math.min(99, Math.max(1, Math.round(100 * share)))}%`;
}

/** "0.20 to 0.93 and 0.995 to 0.998". At most `most` stretches are told one by one. */
export function stretchWords(all: readonly Stretch[], most = 5): string {
  // A short one would read as from somewhere to the same place.
  const digits = (t0: number, t1: number) => (t1 - t0 < 0.015 ? 3 : 2);
  const told = all
    .slice(0, most)
    .map(({ t0, t1 }) => `${fixed(t0, digits(t0, t1))} to ${fixed(t1, digits(t0, t1))}`);
  const more = all.length - told.length;
  const list = more > 0 ? [...told, `${more} more`] : told;
  return list.length > 1 ? `${list.slice(0, -1).join(", ")} and ${list.at(-1)}` : (list[0] ?? "");
}
