/** What a worker of the plane does: a function for each kind of task. */
import { answerOf, inOnePiece } from "#geometry/maps/polygon-family";
import { weighted } from "#geometry/maps/weighted";
import { atResolution, STATE } from "#geometry/states";
import type { Connectedness, Ifs, Locus, PathPoint } from "#wasm/api";
import { rasterized } from "#wasm/bend";
import { frond as core, type Frond } from "#wasm/core";
import { startExact } from "#wasm/exact";
import type { LocusTiles, Proof } from "#wasm/proof";
import type { Context } from "../lanes/task";
import type { Kind, Result, Task } from "./protocol";

/** The way on which all goes at one pace, and how many of its moments are looked at. */
const STRAIGHT: readonly PathPoint[] = [
  [0, 0],
  [1, 1],
];
const STRAIGHT_SAMPLES = 1001;
/** Samples a side of the map by which a way is chosen to be looked at closely. */
const COARSE = 25;

/** Pairs of pieces that are looked at for neighbours: a second or two where numbers are long. */
const MOST_PAIRS = 3000;

/** How single points are decided: a degenerate locus, all of whose samples are that point. */
const POINT = { width: 2, height: 2 } as const;

/** What tasks have at hand: what describes and draws, and what decides and proves. */
interface Tools {
  frond: Omit<Frond, keyof Proof> & Proof;
}
type Hand = Context<null> & Tools;

export const tools = (proof: Proof): Tools => ({ frond: { ...core, ...proof } });

/** The locus that was worked on last is kept, so that each slice does not prepare it again. */
function prepared(keep: Hand["keep"], key: number, make: () => LocusTiles): LocusTiles {
  const last = keep.get("tiles") as { key: number; locus: LocusTiles } | undefined;
  if (last?.key === key) return last.locus;
  last?.locus.free();
  keep.delete("tiles");
  const locus = make();
  keep.set("tiles", { key, locus });
  return locus;
}

function tilesOf({ keep, frond }: Hand, key: number, of: Task<"patch">["of"]): LocusTiles {
  const { FamilyTiles, LocusTiles } = frond;
  return prepared(keep, key, () =>
    "sides" in of
      ? new FamilyTiles({ sides: of.sides }, of.options)
      : new LocusTiles({ maps: of.from }, { maps: of.to }, of.options),
  );
}

/** Buffers are handed over instead of copied. */
function handOver({ transfer }: Hand, { state, gap }: Pick<Locus, "state" | "gap">): Result<"locus"> {
  transfer(state.buffer as ArrayBuffer, gap.buffer as ArrayBuffer);
  return { state, gap };
}

/**
 * All that is known of one shape: the page says nothing else of it anywhere. What the map is made by stops elsewhere,
 * and proves what a search alone does not: neither is to say less than the other.
 */
function answer(frond: Hand["frond"], ifs: Ifs, epsilon: number): Connectedness {
  const found = frond.connectedness(ifs, { epsilon });
  if (found.verdict !== "touching" && found.verdict !== "undecided") return found;
  const bounds = { u0: 0, v0: 0, u1: 0, v1: 0 };
  const point = new frond.LocusTiles(ifs, ifs, { ...POINT, bounds, epsilon });
  try {
    const { state, gap } = point.patch(0, 0, 1, 1);
    const seen = gap[0] ?? 0;
    if (state[0] === STATE.disconnected && seen > 0) {
      // Where a gap was seen, the search is to look as closely.
      const closer = frond.connectedness(ifs, { epsilon: seen / 4 });
      return closer.verdict === "disconnected" ? closer : found;
    }
    const [proved] = state[0] === STATE.touching ? point.prove(0, 0, 1, 1, state) : state;
    return proved === STATE.connected ? inOnePiece(found) : found;
  } finally {
    point.free();
  }
}

export const tasks: { [K in Kind]: (hand: Hand, task: Task<K>) => Result<K> | Promise<Result<K>> } = {
  locus(hand, { key, from, to, options, r0, r1, stride, first }) {
    const make = () => new hand.frond.LocusTiles({ maps: from }, { maps: to }, options);
    return handOver(hand, prepared(hand.keep, key, make).run(r0, r1, stride, first));
  },
  patch(hand, { key, of, x0, y0, x1, y1 }) {
    return handOver(hand, tilesOf(hand, key, of).patch(x0, y0, x1, y1));
  },
  prove(hand, { key, of, x0, y0, x1, y1, state }) {
    const proved = tilesOf(hand, key, of).prove(x0, y0, x1, y1, state);
    hand.transfer(proved.buffer as ArrayBuffer);
    return proved;
  },
  plan({ frond }, task) {
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
  async plan3({ frond, progress, breathe }, { from, to, options }) {
    const search = new frond.PathSearch({ maps: from }, { maps: to }, options);
    try {
      for (;;) {
        const plan = search.step();
        if (plan) return plan;
        // It is alive.
        progress(null);
        await breathe();
      }
    } finally {
      search.free();
    }
  },
  certify: ({ frond }, { from, to, points, options }) =>
    frond.certifyPath({ maps: from }, { maps: to }, points, options),
  certificate({ frond }, { maps, epsilon, connected }) {
    const certificate = connected
      ? frond.connectedCertificate({ maps }, { epsilon })
      : frond.certificate({ maps }, { epsilon });
    return certificate && { certificate, check: frond.checkCertificate(certificate) };
  },
  async exact({ frond }, { module, maps, numbers, epsilon }) {
    const found = (await startExact(module)).proveExact({ maps }, [...numbers], { epsilon });
    return {
      ...found,
      check: found.state === "undecided" ? null : frond.checkCertificate(found.certificate),
    };
  },
  analysis: async (_, { module, maps, numbers }) =>
    (await startExact(module)).analyze({ maps }, [...numbers], { budget: MOST_PAIRS }),
  candidates: ({ frond }, { from, to, limit }) => frond.candidates({ maps: from }, { maps: to }, { limit }),
  rate: ({ frond }, { from, to, options }) => frond.rateCandidate({ maps: from }, { maps: to }, options),
  ways: ({ frond }, { from, to, limit }) => frond.ways(from, to, { limit }),
  way({ frond }, { from, to, options, straight, closely }) {
    const ends: [Ifs, Ifs] = [{ maps: from }, { maps: to }];
    if (straight) {
      const points = [...STRAIGHT];
      const { gap, holds } = frond.checkPath(...ends, points, { ...options, samples: STRAIGHT_SAMPLES });
      return { points, gap, holds, clearance: 0 };
    }
    if (!closely) {
      const { plan } = frond.rateCandidate(...ends, { ...options, size: COARSE });
      if (!plan.holds) return plan;
    }
    return frond.planPath(...ends, options);
  },
  routes: ({ frond }, { from, to }) => frond.routes(from, to),
  verdict({ frond }, { maps, epsilon, polygon }) {
    const found = answer(frond, { maps }, epsilon);
    return polygon ? answerOf(found, polygon.sides, polygon.s) : found;
  },
  states({ frond, transfer }, { from, to, options, points }) {
    const found = new Uint8Array(points.length);
    for (const [i, [u, v, w = 0]] of points.entries()) {
      const bounds = { u0: u, v0: v, u1: u, v1: v };
      const { state, gap } = frond.locus({ maps: from }, { maps: to }, { ...options, ...POINT, bounds, w });
      found[i] = atResolution(state[0] ?? STATE.undecided, gap[0] ?? Number.NaN, options.epsilon);
    }
    transfer(found.buffer);
    return found;
  },
  causes: ({ frond }, { from, to, points, options: { epsilon, ...morph } }) =>
    points.map(([u, v, w = 0]) => {
      const ifs = frond.interpolate({ maps: from }, { maps: to }, { ...morph, u, v, w });
      const { verdict, reason } = frond.connectedness(ifs, { epsilon });
      if (verdict === "connected") return "search";
      if (verdict === "disconnected") return "apart";
      if (verdict !== "touching") return "open";
      return reason ? "rounding" : "near";
    }),
  along: ({ frond }, { from, to, points, options: { epsilon, ...morph } }) =>
    points.map(([u, v, w = 0]) => {
      const ifs = frond.interpolate({ maps: from }, { maps: to }, { ...morph, u, v, w });
      const { verdict, gap, diameter } = answer(frond, ifs, epsilon);
      return { verdict, gap, diameter };
    }),
  async picture({ transfer }, { maps, weights, options, bends }) {
    const { width, height } = options;
    const pixels = await rasterized(weighted(maps, weights), options, bends);
    const image = await createImageBitmap(
      new ImageData(pixels as Uint8ClampedArray<ArrayBuffer>, width, height),
    );
    transfer(image);
    return image;
  },
  buffer({ frond }, { ifs, options }) {
    const { components, overlaps } = frond.indexBuffer(ifs, options);
    return { components, overlaps };
  },
};
