/** Table 1: at which scale an index buffer first calls the gasket connected. */
import type { Channel, Job, Task } from "#workers/pool/protocol";
import { gasket } from "../maps/families";
import { Bisection } from "./bisection";

export const SIZES = [75, 150, 300, 600] as const;
/** What the paper prints for them. */
export const PAPER: readonly number[] = [0.4785, 0.4875, 0.49, 0.49815];
export const MARGIN = 0.05;
/** How many windows are tried for each resolution. */
export const WINDOWS = 9;
/** The scales between which the turn is looked for, and how narrowly. */
const [LOWEST, HIGHEST, WIDTH] = [0.45, 0.53, 1e-4];

/** By how many pixels a window is shifted, both ways: spread evenly, the same every time. */
export function shiftOf(window: number): [number, number] {
  return [((window + 0.5) * 0.7548776662) % 1, ((window + 0.5) * 0.569840291) % 1];
}

/** The gasket's middle: its triangle is that of its corners, whatever the scale. */
const MIDDLE = [0.5, Math.sqrt(0.75) / 2] as const;

/** The window about the middle, shifted by so many pixels of a buffer of that size. */
export function windowOf(size: number, shift: readonly [number, number]): [number, number, number, number] {
  const side = 1 + MARGIN;
  const [x0, y0] = [0, 1].map((axis) => (MIDDLE[axis] ?? 0) - side / 2 - ((shift[axis] ?? 0) * side) / size);
  return [x0 ?? 0, y0 ?? 0, (x0 ?? 0) + side, (y0 ?? 0) + side];
}

export interface Search {
  size: number;
  /** Null: the window in the middle, as it comes. */
  window: number | null;
  bisection: Bisection;
}

export function searches(): Search[] {
  return SIZES.flatMap((size) =>
    [null, ...Array.from({ length: WINDOWS }, (_, i) => i)].map((window) => ({
      size,
      window,
      bisection: new Bisection(LOWEST, HIGHEST, WIDTH),
    })),
  );
}

export const RUNS = SIZES.length * (WINDOWS + 1) * Bisection.answers(LOWEST, HIGHEST, WIDTH);

/** The next question of a search. The chances of the maps are uniform, as in the paper. */
export function runTask({ size, window, bisection }: Search, points: number, seed: number): Task<"buffer"> {
  const options = { size, points, seed, margin: MARGIN };
  const shifted = window === null ? {} : { window: windowOf(size, shiftOf(window)) };
  return { kind: "buffer", ifs: { maps: gasket(bisection.middle) }, options: { ...options, ...shifted } };
}

/** All searches, side by side as far as workers are free: each asks its next question when the last is answered. */
export function measureJob(
  channel: Channel,
  all: readonly Search[],
  options: { points: number; seed: number },
  report: { progress: () => void; done: () => void; fail: (message: string) => void },
): Job<"buffer"> {
  const asking = new Map<object, { search: Search; at: number }>();
  const busy = new Set<Search>();
  return {
    channel,
    priority: () => 30,
    next() {
      const search = all.find((one) => !one.bisection.done && !busy.has(one));
      if (!search) return null;
      const task = runTask(search, options.points, options.seed + (search.window ?? 0));
      asking.set(task, { search, at: search.bisection.middle });
      busy.add(search);
      return task;
    },
    accept(task, { components: [first, second, third] }) {
      const asked = asking.get(task);
      if (!asked) return;
      asking.delete(task);
      busy.delete(asked.search);
      asked.search.bisection.tell(asked.at, first === second && second === third);
      report.progress();
    },
    fail(_, error) {
      report.fail(error.message);
    },
    done: report.done,
  };
}

/** The least scale, to 1e-8, that pair subdivision does not prove disconnected. */
export function exactJob(channel: Channel, epsilon: number, found: (r: number) => void): Job<"verdict"> {
  const bisection = new Bisection(0.4, 0.51, 1e-8);
  let at = bisection.middle;
  let waiting = false;
  return {
    channel,
    priority: () => 35,
    next() {
      if (waiting || bisection.done) return null;
      waiting = true;
      at = bisection.middle;
      return { kind: "verdict", maps: gasket(at), epsilon };
    },
    accept(_, answer) {
      waiting = false;
      bisection.tell(at, answer.verdict !== "disconnected");
    },
    fail() {
      waiting = false;
      bisection.tell(at, false);
    },
    done: () => found(bisection.high),
  };
}
