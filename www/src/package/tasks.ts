/** What a worker of the package's pool does: any function of the package, long ones in parts. */

import type { LocusOptions } from "#wasm/api";
import { performerOf } from "#workers/lanes/performer";
import type { Context } from "#workers/lanes/task";
import type { Picture3 } from "./command/modules";
import type { Name } from "./names";

type Proof = typeof import("../../pkg/frond-proof.js");
type Space = typeof import("../../pkg/frond-space.js");
type Fit = typeof import("../../pkg/frond-fit.js");
// biome-ignore lint/suspicious/noExplicitAny: functions are called as they were by the one who asked
type Functions = Record<string, (...args: any[]) => unknown>;

/** The modules, started when first asked for. */
export type Sources = Record<"draw" | "proof" | "fit" | "space", () => Promise<unknown>>;
export type Hand = Context<number> & { sources: Sources };

interface Rows {
  /** Tells loci apart, so that a worker prepares each only once. */
  key: number;
  ends: [from: unknown, to: unknown, options: LocusOptions];
  r0: number;
  r1: number;
}

/** Milliseconds of a fit between two words of how far it is. */
const PART_MS = 100;

/** Pieces of a picture of space between two breaths. */
const PIECES = 200_000;

/** A fit, in parts. It is given up with the task. */
async function inParts<Made>(
  { breathe, progress }: Hand,
  fit: { step(ms: number): { share: number; done: boolean }; measured(): Made; free(): void },
): Promise<Made> {
  try {
    for (;;) {
      const { share, done } = fit.step(PART_MS);
      if (done) return fit.measured();
      progress(share);
      await breathe();
    }
  } finally {
    fit.free();
  }
}

export const tasks = {
  async call(
    { sources }: Hand,
    { source, name, args }: { source: keyof Sources; name: Name; args: unknown[] },
  ) {
    return ((await sources[source]()) as Functions)[name]?.(...args);
  },
  async locus({ sources, keep, transfer }: Hand, { key, ends, r0, r1 }: Rows) {
    const proof = (await sources.proof()) as Proof;
    const last = keep.get("tiles") as { key: number; tiles: InstanceType<Proof["LocusTiles"]> } | undefined;
    let tiles = last?.tiles;
    if (!tiles || last?.key !== key) {
      keep.delete("tiles");
      tiles?.free();
      tiles = new proof.LocusTiles(...(ends as ConstructorParameters<Proof["LocusTiles"]>));
      keep.set("tiles", { key, tiles });
    }
    const { state, gap } = tiles.run(r0, r1, 1, true);
    transfer(state.buffer as ArrayBuffer, gap.buffer as ArrayBuffer);
    return { state, gap };
  },
  async planPath({ sources, breathe }: Hand, args: unknown[]) {
    const { PathSearch } = (await sources.proof()) as Proof;
    const search = new PathSearch(...(args as ConstructorParameters<Proof["PathSearch"]>));
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
  async fitCurve(hand: Hand, args: unknown[]) {
    const { CurveFit, fitCurve } = (await hand.sources.fit()) as Fit;
    const [outline, { model = "closed", numbers = 260 } = {}] = args as Parameters<Fit["fitCurve"]>;
    if (model !== "closed") return fitCurve(...(args as Parameters<Fit["fitCurve"]>));
    return inParts(hand, new CurveFit(outline, numbers));
  },
  async fitWithin(hand: Hand, args: unknown[]) {
    const { SplineFit } = (await hand.sources.fit()) as Fit;
    return inParts(hand, new SplineFit(...(args as ConstructorParameters<Fit["SplineFit"]>)));
  },
  /** A complete picture of space. */
  async rasterize3(hand: Hand, [picture]: [Picture3]) {
    const pixels = await solidPixels(hand, picture);
    hand.transfer(pixels.buffer);
    return pixels;
  },
};

/** A complete picture of space, in parts. */
export async function solidPixels(
  { sources, breathe }: Pick<Hand, "breathe"> & { sources: Pick<Sources, "space"> },
  { objects, view, light, look }: Picture3,
) {
  const { SpacePicture } = (await sources.space()) as Space;
  const made = new SpacePicture(objects);
  try {
    const carve = made.carve(view, look.width * look.factor, look.height * look.factor);
    try {
      while (!carve.run(PIECES)) await breathe();
      return carve.paint(light, look);
    } finally {
      carve.free();
    }
  } finally {
    made.free();
  }
}

/** The inside of a worker. */
export const performerFrom = (sources: Sources) => performerOf(tasks, async () => ({ sources }));
