import { signal } from "@preact/signals";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { Way } from "#workers/directed/moment";
import type { LocusSoFar } from "#workers/lanes/locus-fill";

const asked = vi.hoisted(
  () =>
    [] as {
      way: unknown;
      signal: AbortSignal;
      onProgress: (locus: unknown) => void;
      end: (locus: unknown) => void;
    }[],
);
const way = signal<Way | null>(null);
vi.mock("#document/directed/directed", () => ({ directedWay: way }));
vi.mock("#workers/directed/client", () => ({
  directedTask: (
    _name: string,
    of: unknown,
    { signal, onProgress }: { signal: AbortSignal; onProgress: () => void },
  ) =>
    new Promise((end, reject) => {
      signal.addEventListener("abort", () => reject({ code: "stopped", message: "" }));
      asked.push({ way: of, signal, onProgress, end });
    }),
}));
const { field, inSight, watchLocus } = await import("./work");

const to = (x: number): Way => ({
  from: { states: [] },
  to: { states: [[{ from: 0, map: [0.5, 0, 0, 0.5, x, 0] }]] },
  mode: "linear",
});
const locus = (progress: number) => ({ progress }) as LocusSoFar;
let stop = () => {};

beforeEach(() => {
  vi.useFakeTimers();
  asked.length = 0;
  stop = watchLocus();
});
afterEach(() => {
  stop();
  inSight.value = false;
  way.value = null;
  vi.useRealTimers();
});

it("a map is begun once it is in sight, and goes on out of it", () => {
  way.value = to(1);
  vi.runAllTimers();
  expect(asked).toHaveLength(0);
  inSight.value = true;
  vi.runAllTimers();
  inSight.value = false;
  inSight.value = true;
  vi.runAllTimers();
  expect(asked).toHaveLength(1);
  expect(asked[0]?.signal.aborted).toBe(false);
  asked[0]?.onProgress(locus(0.5));
  expect(field.value?.locus.progress).toBe(0.5);
});

it("of two ways only the later counts, and one that is whole is not made again", async () => {
  inSight.value = true;
  way.value = to(1);
  vi.runAllTimers();
  way.value = to(2);
  vi.runAllTimers();
  expect(asked.map(({ signal }) => signal.aborted)).toEqual([true, false]);
  asked[0]?.onProgress(locus(0.9));
  expect(field.value).toBeNull();
  asked[1]?.end(locus(1));
  await Promise.resolve();
  await Promise.resolve();
  expect(field.value?.way).toBe(way.value);
  stop();
  stop = watchLocus();
  vi.runAllTimers();
  expect(asked).toHaveLength(2);
});
