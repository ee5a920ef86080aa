/** `frond-ifs/pool`: functions of the package that take their time, in workers of its own. */
import type { Locus, LocusOptions } from "#wasm/api";
import { Lane } from "#workers/lanes/lane";
import type { WorkerLike } from "#workers/lanes/task";
import { NAMES, type Name } from "./names";

export { performerFrom } from "./tasks";

interface How {
  signal?: AbortSignal;
  /** 0 to 1. */
  onProgress?: (share: number) => void;
}

/** Parts of a locus for each worker, so that none waits long for the last. */
const PARTS = 32;

interface Hand {
  lane: Lane<null>;
  load: number;
}

/** Workers that are asked for tasks by name. */
export type Lanes = ReturnType<typeof lanesOf>;

/** `spawn` makes a worker whose inside is that of `performerFrom`. */
export function lanesOf(spawn: () => WorkerLike<null>, size: number) {
  if (!(Number.isInteger(size) && size > 0))
    throw made("bad-input", "The size of a pool is a whole number from 1 on.");
  const hands: Hand[] = Array.from({ length: size }, () => ({
    lane: new Lane(spawn, async () => null),
    load: 0,
  }));
  let next = 1;
  let closed = false;

  /** To the worker that has least to do. */
  function ask<T>(
    name: string,
    args: unknown,
    { signal, onProgress }: How,
    stops?: (() => void)[],
  ): Promise<T> {
    const hand = hands.reduce((least, other) => (other.load < least.load ? other : least));
    const id = next++;
    hand.load++;
    const stop = () => hand.lane.stop(id);
    stops?.push(stop);
    return new Promise<T>((resolve, reject) => {
      if (closed) throw { code: "closed", message: "This pool is closed. Make another." };
      signal?.throwIfAborted();
      signal?.addEventListener("abort", stop, { once: true });
      hand.lane.give({
        ask: { type: "run", id, name, args },
        transfer: [],
        onProgress: (share) => onProgress?.(share as number),
        resolve: (result) => resolve(result as T),
        reject,
      });
    })
      .catch((problem: unknown) => {
        throw signal?.aborted ? signal.reason : failure(problem);
      })
      .finally(() => {
        hand.load--;
        signal?.removeEventListener("abort", stop);
      });
  }

  return {
    size,
    ask,
    /** Tells apart what several workers are asked for. */
    key: () => next++,
    /** Ends the workers. What is under way is rejected. */
    close() {
      closed = true;
      for (const { lane } of hands) lane.close();
    },
  };
}

export const poolOf = (spawn: () => WorkerLike<null>, size: number) => poolOn(lanesOf(spawn, size));

/** The functions of the package, asked of these workers. */
export function poolOn({ size, ask, key: another, close }: Lanes) {
  /** Rows of it side by side. */
  async function locus(ends: [unknown, unknown, LocusOptions], { signal, onProgress }: How): Promise<Locus> {
    const { width, height } = ends[2] ?? {};
    const whole = { source: "proof", name: "locus", args: ends };
    // What is wrong with the size is said by who knows.
    if (
      !(
        Number.isInteger(width) &&
        Number.isInteger(height) &&
        width > 1 &&
        height > 1 &&
        width * height <= 1 << 24
      )
    )
      return ask("call", whole, { ...(signal ? { signal } : {}) });
    const key = another();
    const rows = Math.max(1, Math.ceil(height / (PARTS * size)));
    const state = new Uint8Array(width * height);
    const gap = new Float32Array(width * height);
    let done = 0;
    signal?.throwIfAborted();
    // One that fails, or is called off, calls off the others.
    const stops: (() => void)[] = [];
    const stopAll = () => {
      for (const stop of stops) stop();
    };
    signal?.addEventListener("abort", stopAll, { once: true });
    const part = async (r0: number) => {
      const r1 = Math.min(height, r0 + rows);
      const found = await ask<Pick<Locus, "state" | "gap">>("locus", { key, ends, r0, r1 }, {}, stops);
      state.set(found.state, r0 * width);
      gap.set(found.gap, r0 * width);
      done += r1 - r0;
      if (!signal?.aborted) onProgress?.(done / height);
    };
    try {
      await Promise.all(Array.from({ length: Math.ceil(height / rows) }, (_, i) => part(i * rows)));
    } catch (problem) {
      stopAll();
      throw signal?.aborted ? signal.reason : problem;
    } finally {
      signal?.removeEventListener("abort", stopAll);
    }
    return { width, height, state, gap } as Locus;
  }

  async function run(name: Name, all: unknown[]): Promise<unknown> {
    const [source, count] = NAMES[name];
    const args = all.slice(0, count);
    const how = (all[count] ?? {}) as How;
    if (name === "locus") return locus(args as [unknown, unknown, LocusOptions], how);
    const parts = name === "planPath" || name === "fitCurve" || name === "fitWithin" || name === "rasterize3";
    const result = await (parts ? ask(name, args, how) : ask("call", { source, name, args }, how));
    how.onProgress?.(1);
    return result;
  }

  const names = Object.keys(NAMES) as Name[];
  return {
    ...Object.fromEntries(names.map((name) => [name, (...args: unknown[]) => run(name, args)])),
    size,
    close,
  };
}

/** A `FrondError`, wherever it was found: what comes from a worker is no more than its code and its words. */
function failure(problem: unknown): unknown {
  const { name, code, message } = (problem ?? {}) as { name?: string; code?: unknown; message?: string };
  if (name === "FrondError") return problem;
  // Workers are sent values, not functions.
  if (name === "DataCloneError")
    return made(
      "bad-input",
      `This cannot be sent to a worker: ${message}. Give numbers, texts, lists and objects of these.`,
    );
  return made(typeof code === "string" ? code : "failed", message ?? String(problem));
}

/** What tells a `FrondError` is its form: the package's class of that name knows it by that. */
function made(code: string, message: string): Error {
  const error = Object.assign(new Error(message), { code });
  return Object.defineProperty(error, "name", { value: "FrondError", configurable: true, writable: true });
}
