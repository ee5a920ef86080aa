/** The moment of what plays, from 0 to 1. */

/** From one end to the other, at the speed 1. */
export const SECONDS = 8;

/** Where the moment is after `dt` seconds, and which way it then goes. Pure, for the tests. */
export function advance(
  t: number,
  dt: number,
  way: number,
  options: { speed: number; loop: boolean },
): { t: number; way: number; ended: boolean } {
  let next = t + (way * dt * options.speed) / SECONDS;
  let onward = way;
  if (!options.loop) return { t: Math.min(1, Math.max(0, next)), way, ended: next >= 1 || next < 0 };
  // Reflect at both ends; a long pause may pass several.
  next = ((next % 2) + 2) % 2;
  if (next > 1) {
    next = 2 - next;
    onward = -way;
  }
  return { t: next, way: onward, ended: false };
}
