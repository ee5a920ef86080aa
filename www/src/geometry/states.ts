import type { Bounds, Locus } from "#wasm/api";
import { type Uv, uvAt } from "./path";

export interface Stretch {
  t0: number;
  t1: number;
}

/**
 * The states of `Locus.state`, and two of the page: a gap that is proved and too narrow to be seen, and a sample not
 * decided yet.
 */
export const STATE = {
  connected: 0,
  touching: 1,
  disconnected: 2,
  undecided: 3,
  none: 4,
  hidden: 5,
  pending: 255,
} as const;

/** The state as this resolution shows it: pieces may be proved apart and yet be within epsilon of each other. */
export function atResolution(state: number, gap: number, epsilon: number): number {
  return state === STATE.disconnected && gap <= epsilon ? STATE.hidden : state;
}

/** The state as the programming interface numbers it. */
export function atAll(state: number): number {
  return state === STATE.hidden ? STATE.disconnected : state;
}

/** Whether it is broken for all to see. */
export function isBroken(state: number): boolean {
  return state === STATE.disconnected || state === STATE.none;
}

/** The part of what holds that is proved, in [0, 1]; null where nothing holds. */
export function provedPart(states: ArrayLike<number>): number | null {
  let [proved, holds] = [0, 0];
  for (let i = 0; i < states.length; i++) {
    const is = states[i] === STATE.connected;
    if (is) proved++;
    if (is || states[i] === STATE.touching) holds++;
  }
  return holds > 0 ? proved / holds : null;
}

/** A moment of a path, and how wide the widest gap is there, relative to the size of the shape. */
export interface Worst {
  t: number;
  gap: number;
}

/**
 * Where, of samples evenly spaced over [0, 1], the gap is widest: the middle of the first run of it. Null if none is in
 * pieces.
 */
export function widestOf(states: ArrayLike<number>, gaps: ArrayLike<number>): Worst | null {
  const last = Math.max(1, states.length - 1);
  const gapAt = (i: number) => {
    const gap = gaps[i] ?? Number.NaN;
    return atAll(states[i] ?? STATE.pending) === STATE.disconnected && gap > 0 ? gap : 0;
  };
  let first = -1;
  let most = 0;
  for (let i = 0; i < states.length; i++) {
    if (gapAt(i) <= most) continue;
    first = i;
    most = gapAt(i);
  }
  if (first < 0) return null;
  let end = first;
  while (end + 1 < states.length && gapAt(end + 1) === most) end++;
  return { t: (first + end) / 2 / last, gap: most };
}

/**
 * Stretches of t in which samples, evenly spaced over [0, 1], are broken, or as `is` says. Each reaches half a sample
 * to both sides.
 */
export function stretches(states: ArrayLike<number>, is: (state: number) => boolean = isBroken): Stretch[] {
  const count = states.length;
  const found: Stretch[] = [];
  let from = -1;
  for (let i = 0; i <= count; i++) {
    const within = i < count && is(states[i] ?? STATE.pending);
    if (within && from < 0) from = i;
    if (!within && from >= 0) {
      const at = (x: number) => Math.min(1, Math.max(0, x / Math.max(1, count - 1)));
      found.push({ t0: at(from - 0.5), t1: at(i - 0.5) });
      from = -1;
    }
  }
  return found;
}

/**
 * The states of a path at even moments, read off a field: the nearest sample, or the four corners of its cell, may hold
 * it together.
 */
export function statesAlong(
  field: Locus & { bounds: Bounds },
  points: readonly Uv[],
  samples = 257,
): Uint8Array {
  const states = new Uint8Array(samples);
  for (let i = 0; i < samples; i++) states[i] = stateNear(field, uvAt(points, i / (samples - 1)));
  return states;
}

/** Clearance does not count so near to the ends of a path, which often lie on the very border of what holds. */
const NEAR_END = 0.125;

/** How far a path in the plane of a field keeps from what is broken there; Infinity where nothing is. */
export function clearanceOf(field: Field, points: readonly Uv[], samples = 240): number {
  const border = borderOf(field);
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; i < samples; i++) {
    const [u, v] = uvAt(points, i / (samples - 1));
    if (Math.hypot(u, v) < NEAR_END || Math.hypot(u - 1, v - 1) < NEAR_END) continue;
    for (let k = 0; k < border.length; k += 2) {
      const [x, y] = [(border[k] ?? 0) - u, (border[k + 1] ?? 0) - v];
      least = Math.min(least, x * x + y * y);
    }
  }
  return Math.sqrt(least);
}

type Field = Locus & { bounds: Bounds };
/** The same field is asked for every path that is dragged through it. */
const borders = new WeakMap<Field, Float64Array>();

/** Broken samples next to others: u0, v0, u1, v1, .. */
function borderOf(field: Field): Float64Array {
  const known = borders.get(field);
  if (known) return known;
  const { width, height, bounds, state } = field;
  const at = (x: number, low: number, high: number, count: number) => low + (x / (count - 1)) * (high - low);
  const broken = (i: number) => isBroken(state[i] ?? STATE.disconnected);
  const found: number[] = [];
  for (let row = 0; row < height; row++) {
    for (let column = 0; column < width; column++) {
      const i = row * width + column;
      if (!broken(i)) continue;
      const inside =
        (column === 0 || broken(i - 1)) &&
        (column === width - 1 || broken(i + 1)) &&
        broken(i - width) &&
        broken(i + width);
      if (!inside) found.push(at(column, bounds.u0, bounds.u1, width), at(row, bounds.v0, bounds.v1, height));
    }
  }
  const border = Float64Array.from(found);
  borders.set(field, border);
  return border;
}

export const stateNear = (field: Field, point: Uv): number => sampleNear(field, point).state;

/** The best of the corners of the cell that holds a point: a thin isthmus must not read as a break. */
export function sampleNear(field: Field, [u, v]: Uv): { state: number; gap: number } {
  const { width, height, bounds, state, gap } = field;
  const x = ((u - bounds.u0) / (bounds.u1 - bounds.u0)) * (width - 1);
  const y = ((v - bounds.v0) / (bounds.v1 - bounds.v0)) * (height - 1);
  // Within rounding of a sample that sample alone speaks.
  const xs = Math.abs(x - Math.round(x)) < 1e-6 ? [Math.round(x)] : [Math.floor(x), Math.ceil(x)];
  const ys = Math.abs(y - Math.round(y)) < 1e-6 ? [Math.round(y)] : [Math.floor(y), Math.ceil(y)];
  let best: { state: number; gap: number } = { state: STATE.pending, gap: Number.NaN };
  for (const row of ys) {
    for (const column of xs) {
      if (row < 0 || column < 0 || row >= height || column >= width) continue;
      const at = row * width + column;
      const s = state[at] ?? STATE.pending;
      if (rank(s) < rank(best.state)) best = { state: s, gap: gap[at] ?? Number.NaN };
    }
  }
  return best;
}

function rank(state: number): number {
  if (state === STATE.hidden) return 1.25;
  if (state === STATE.undecided) return 1.5;
  return state;
}
