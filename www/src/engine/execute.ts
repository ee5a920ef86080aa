import type { Ifs } from "./api";
import { atResolution, STATE } from "./breaks";
import type { Kind, Result, Task } from "./protocol";
import type { Frond, LocusTiles } from "./wasm";

/** How many samples `states` decides from one call: a degenerate locus of a single point. */
const POINT = { width: 2, height: 2 } as const;

/** Does tasks, one at a time. It keeps the locus it worked on last, so that each slice does not prepare it again. */
export function executor(
  frond: Frond,
): (task: Task) => Promise<{ result: Result; transfer: Transferable[] }> {
  let tiles: { key: number; locus: LocusTiles } | null = null;

  const handlers: { [K in Kind]: (task: Task<K>) => Result<K> | Promise<Result<K>> } = {
    locus(task) {
      if (tiles?.key !== task.key) {
        tiles?.locus.free();
        tiles = null;
        const ends: [Ifs, Ifs] = [{ maps: task.from }, { maps: task.to }];
        tiles = { key: task.key, locus: new frond.LocusTiles(...ends, task.options) };
      }
      const { state, gap } = tiles.locus.run(task.r0, task.r1, task.stride, task.first);
      return { state, gap };
    },
    plan(task) {
      const plan = frond.planPathIn(task.locus, task.bounds);
      if (!task.refine) return plan;
      const { from, to, options } = task.refine;
      const ends: [Ifs, Ifs] = [{ maps: from }, { maps: to }];
      const check = frond.checkPath(...ends, plan.points, options);
      const checked = { points: plan.points, gap: check.gap, holds: check.holds };
      if (check.holds) return checked;
      const finer = frond.planPath(...ends, options);
      return finer.holds || finer.gap < check.gap ? finer : checked;
    },
    verdict: (task) => frond.connectedness({ maps: task.maps }, { epsilon: task.epsilon }),
    states(task) {
      const states = new Uint8Array(task.points.length);
      for (const [i, [u, v]] of task.points.entries()) {
        const bounds = { u0: u, v0: v, u1: u, v1: v };
        const options = { ...task.options, ...POINT, bounds };
        const { state, gap } = frond.locus({ maps: task.from }, { maps: task.to }, options);
        states[i] = atResolution(state[0] ?? STATE.undecided, gap[0] ?? Number.NaN, task.options.epsilon);
      }
      return states;
    },
    async picture(task) {
      const { width, height } = task.options;
      const pixels = frond.rasterize({ maps: task.maps }, task.options);
      const image = new ImageData(pixels as Uint8ClampedArray<ArrayBuffer>, width, height);
      return createImageBitmap(image);
    },
    buffer(task) {
      const { components, overlaps } = frond.indexBuffer(task.ifs, task.options);
      return { components, overlaps };
    },
  };

  return async (task) => {
    const handle = handlers[task.kind] as (task: Task) => Result | Promise<Result>;
    const result = await handle(task);
    return { result, transfer: transferable(result) };
  };
}

/** Buffers are handed over instead of copied. */
function transferable(result: Result): Transferable[] {
  if (result instanceof Uint8Array) return [result.buffer as ArrayBuffer];
  if (typeof ImageBitmap !== "undefined" && result instanceof ImageBitmap) return [result];
  if ("state" in result && "gap" in result) {
    return [result.state.buffer as ArrayBuffer, result.gap.buffer as ArrayBuffer];
  }
  return [];
}
