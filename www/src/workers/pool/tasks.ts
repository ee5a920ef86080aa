/** What a worker of the plane does: a handler for each kind of task. */
import { answerOf } from "#geometry/maps/polygon-family";
import { atResolution, STATE } from "#geometry/states";
import type { Connectedness, Ifs } from "#wasm/api";
import type { Frond } from "#wasm/core";
import type { LocusTiles, Proof } from "#wasm/proof";
import type { Kind, Result, Task } from "./protocol";

/** How single points are decided: a degenerate locus, all of whose samples are that point. */
const POINT = { width: 2, height: 2 } as const;

/** Lets others have their turn; throws when the task is not wanted any more. */
export type Breathe = () => Promise<void>;

const pause: Breathe = () => new Promise((resolve) => setTimeout(resolve));

/**
 * Does tasks, one at a time. Between the parts of a long one it breathes. It keeps the locus it worked on last, so that
 * each slice does not prepare it again.
 */
export function executor(
  frond: Omit<Frond, keyof Proof> & Proof,
  breathe: Breathe = pause,
): (task: Task) => Promise<{ result: Result; transfer: Transferable[] }> {
  let tiles: { key: number; locus: LocusTiles } | null = null;

  const prepared = (key: number, make: () => LocusTiles): LocusTiles => {
    if (tiles?.key === key) return tiles.locus;
    tiles?.locus.free();
    tiles = null;
    const locus = make();
    tiles = { key, locus };
    return locus;
  };

  const decided = (task: Task<"states">): Result<"states"> => {
    const found = new Uint8Array(task.points.length);
    for (const [i, [u, v, w = 0]] of task.points.entries()) {
      const bounds = { u0: u, v0: v, u1: u, v1: v };
      const options = { ...task.options, ...POINT, bounds, w };
      const { state, gap } = frond.locus({ maps: task.from }, { maps: task.to }, options);
      found[i] = atResolution(state[0] ?? STATE.undecided, gap[0] ?? Number.NaN, task.options.epsilon);
    }
    return found;
  };

  /** All that is known of one shape: the page says nothing else of it anywhere. */
  const answer = (ifs: Ifs, epsilon: number): Connectedness => {
    const found = frond.connectedness(ifs, { epsilon });
    if (found.verdict !== "touching" && found.verdict !== "undecided") return found;
    // The search that maps are made by stops elsewhere: where it has seen a gap, this one is to look as closely.
    const bounds = { u0: 0, v0: 0, u1: 0, v1: 0 };
    const { state, gap } = frond.locus(ifs, ifs, { ...POINT, bounds, epsilon });
    const seen = gap[0] ?? 0;
    if (state[0] !== STATE.disconnected || !(seen > 0)) return found;
    const closer = frond.connectedness(ifs, { epsilon: seen / 4 });
    return closer.verdict === "disconnected" ? closer : found;
  };

  /** The same along a path. */
  const told = ({ from, to, points, options }: Task<"along">): Result<"along"> =>
    points.map(([u, v, w = 0]) => {
      const { epsilon, ...morph } = options;
      const ifs = frond.interpolate({ maps: from }, { maps: to }, { ...morph, u, v, w });
      const { verdict, gap, diameter } = answer(ifs, epsilon);
      return { verdict, gap, diameter };
    });

  const handlers: { [K in Kind]: (task: Task<K>) => Result<K> | Promise<Result<K>> } = {
    locus(task) {
      const locus = prepared(
        task.key,
        () => new frond.LocusTiles({ maps: task.from }, { maps: task.to }, task.options),
      );
      const { state, gap } = locus.run(task.r0, task.r1, task.stride, task.first);
      return { state, gap };
    },
    plan(task) {
      if (!task.refine) return frond.planPathIn(task.locus, task.bounds);
      const { from, to, options } = task.refine;
      const ends: [Ifs, Ifs] = [{ maps: from }, { maps: to }];
      // With the maps at hand it looks between the samples, and leaves out every corner that it can do without.
      const finer = frond.planPath(...ends, options);
      if (finer.holds) return finer;
      const plan = frond.planPathIn(task.locus, task.bounds);
      const check = frond.checkPath(...ends, plan.points, options);
      return finer.gap <= check.gap ? finer : { ...plan, gap: check.gap, holds: check.holds };
    },
    patch({ key, of, x0, y0, x1, y1 }) {
      const locus = prepared(key, () =>
        "sides" in of
          ? new frond.FamilyTiles({ sides: of.sides }, of.options)
          : new frond.LocusTiles({ maps: of.from }, { maps: of.to }, of.options),
      );
      const { state, gap } = locus.patch(x0, y0, x1, y1);
      return { state, gap };
    },
    async plan3(task) {
      const search = new frond.PathSearch({ maps: task.from }, { maps: task.to }, task.options);
      try {
        for (;;) {
          const plan = search.step();
          if (plan) return plan;
          await breathe();
        }
      } finally {
        search.free();
      }
    },
    certify: ({ from, to, points, options }) =>
      frond.certifyPath({ maps: from }, { maps: to }, [...points], options),
    certificate({ maps, epsilon }) {
      const certificate = frond.certificate({ maps }, { epsilon });
      return certificate && { certificate, check: frond.checkCertificate(certificate) };
    },
    candidates: (task) => frond.candidates({ maps: task.from }, { maps: task.to }, { limit: task.limit }),
    rate: (task) => frond.rateCandidate({ maps: task.from }, { maps: task.to }, task.options),
    routes: (task) => frond.routes({ maps: task.from }, { maps: task.to }),
    verdict({ maps, epsilon, polygon }) {
      const found = answer({ maps }, epsilon);
      return polygon ? answerOf(found, polygon.sides, polygon.s) : found;
    },
    states: decided,
    along: told,
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
  if (typeof result !== "object" || result === null) return [];
  if ("state" in result && "gap" in result) {
    return [result.state.buffer as ArrayBuffer, result.gap.buffer as ArrayBuffer];
  }
  return [];
}
