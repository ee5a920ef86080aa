/** A stalk: a long thin part of an outline that sticks out of it. */
import { computed, type ReadonlySignal } from "@preact/signals";
import { settings } from "./mask";
import { prepared } from "./outline";
import { opened } from "./source";

/** Points all along the outline, as far from each other along it as the next. */
const LOOKS = 500;
/** As wide as a stalk may be that is taken off, in parts of the side of a square as large as the leaf. */
const WIDEST = 0.055;
/** As long as it has to be, in parts of the diagonal of the outline's box. */
const SHORTEST = 0.13;
/** Twice as long around as from foot to tip, and a little more where it is bent. */
const AROUND = 2.6;

/** How long the stalk is, in parts of the diagonal of the box of x0, y0, x1, y1, ..; 0 where there is none. */
export function stalkOf(points: ArrayLike<number>): number {
  const { xs, ys, step, size } = evenly(points);
  const count = xs.length;
  if (count < LOOKS || size === 0) return 0;
  const at = (of: readonly number[], i: number) => of[i % count] ?? 0;
  // Twice the area that the outline sweeps from its start to each point, seen from the origin.
  const swept = [0];
  for (let i = 0; i < 2 * count; i++) {
    const cross = at(xs, i) * at(ys, i + 1) - at(xs, i + 1) * at(ys, i);
    swept.push((swept[i] ?? 0) + cross);
  }
  const widest = WIDEST * Math.sqrt(Math.abs(swept[count] ?? 0) / 2);
  let longest = 0;
  for (let i = 0; i < count; i++) {
    const [x, y] = [at(xs, i), at(ys, i)];
    const least = Math.ceil((2 * SHORTEST * size) / step);
    for (let along = least; along <= count / 2; along++) {
      const j = i + along;
      const [u, v] = [at(xs, j), at(ys, j)];
      if (Math.hypot(u - x, v - y) > widest) continue;
      const tip = i + Math.round(along / 2);
      const reach = Math.hypot(at(xs, tip) - (x + u) / 2, at(ys, tip) - (y + v) / 2);
      if (reach <= longest || along * step > AROUND * reach + widest) continue;
      const area = Math.abs((swept[j] ?? 0) - (swept[i] ?? 0) + u * y - x * v) / 2;
      if (area <= widest * reach) longest = reach;
    }
  }
  return longest >= SHORTEST * size ? longest / size : 0;
}

/** Points as far from each other, along the outline, and the diagonal of its box. */
function evenly(points: ArrayLike<number>): { xs: number[]; ys: number[]; step: number; size: number } {
  const count = Math.floor(points.length / 2);
  const x = (i: number) => points[2 * (i % count)] ?? 0;
  const y = (i: number) => points[2 * (i % count) + 1] ?? 0;
  const [xs, ys]: [number[], number[]] = [[], []];
  let around = 0;
  let [x0, x1, y0, y1] = [x(0), x(0), y(0), y(0)];
  for (let i = 0; i < count; i++) {
    around += Math.hypot(x(i + 1) - x(i), y(i + 1) - y(i));
    [x0, x1] = [Math.min(x0, x(i)), Math.max(x1, x(i))];
    [y0, y1] = [Math.min(y0, y(i)), Math.max(y1, y(i))];
  }
  const step = around / LOOKS;
  if (!(step > 0 && Number.isFinite(step))) return { xs, ys, step: 0, size: 0 };
  let gone = 0;
  for (let i = 0; i < count && xs.length < LOOKS; i++) {
    const long = Math.hypot(x(i + 1) - x(i), y(i + 1) - y(i));
    while (xs.length < LOOKS && xs.length * step <= gone + long) {
      const part = long > 0 ? (xs.length * step - gone) / long : 0;
      xs.push(x(i) + part * (x(i + 1) - x(i)));
      ys.push(y(i) + part * (y(i + 1) - y(i)));
    }
    gone += long;
  }
  return { xs, ys, step, size: Math.hypot(x1 - x0, y1 - y0) };
}

const found = computed(() => (opened.value && prepared.value ? stalkOf(prepared.value.points) : 0));

/** How long the stalk is that could be taken off the photograph's outline, in parts of its size; 0: there is none. */
export const stalk: ReadonlySignal<number> = computed(() =>
  settings.value.stalk === "keep" ? found.value : 0,
);
