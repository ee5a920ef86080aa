/** How a film goes through what moves: which moment each of its frames shows. The only place that knows. */
import type { Repeat } from "#wasm/api";

export type Easing = "linear" | "ease";

export interface Pace {
  /** "ease" starts and stops gently, as ease-in-out does elsewhere. */
  easing: Easing;
  /** So many frames more stand still at each end. */
  held: number;
}

export const STEADY: Pace = { easing: "linear", held: 0 };

/** The part of the way after a part of the time: 3t^2 - 2t^3, which stands still at both ends. */
export const eased = (t: number, easing: Easing): number => (easing === "ease" ? t * t * (3 - 2 * t) : t);

/** The most seconds that a film stands still at each end. */
export const MOST_HOLD = 10;

/** Frames that stand still at each end. What goes round has no ends. */
export const heldFrames = (hold: number, fps: number, repeat: Repeat): number =>
  repeat === "round" ? 0 : Math.max(0, Math.round(hold * fps));

/**
 * The moments of all frames, of which `moving` move and the others stand still. Where the film goes round, or to and
 * fro, a frame more would be the first again. Where it ends, its last frame shows the end.
 */
export function momentsOf(
  { from, to }: { from: number; to: number },
  moving: number,
  repeat: Repeat,
  { easing, held }: Pace = STEADY,
): number[] {
  const still = (at: number) => Array.from({ length: held }, () => at);
  // Step k of so many. Quotients of whole numbers keep the way back exactly what the way there was.
  const at = (k: number, steps: number) => {
    if (easing === "linear" || repeat === "round") return from + (k * (to - from)) / steps;
    return k === steps ? to : from + eased(k / steps, easing) * (to - from);
  };
  const steps = Array.from({ length: moving }, (_, i) => i);
  if (repeat === "round") return steps.map((i) => at(i, moving));
  if (repeat === "once") {
    const last = moving - 1;
    return [
      ...still(from),
      ...steps.map((i) => (i > 0 && i === last ? to : at(i, Math.max(1, last)))),
      ...still(to),
    ];
  }
  const half = moving / 2;
  const there = steps.filter((i) => i <= half).map((i) => at(i, half));
  const back = steps.filter((i) => i > half).map((i) => at(moving - i, half));
  return [...still(from), ...there, ...still(to), ...back];
}
