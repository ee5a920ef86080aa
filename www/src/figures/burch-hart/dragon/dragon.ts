/** What Figures 5, 6 and 7 have in common: the two shapes, the locus between them, and the path through it. */
import { computed, effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import { BOUNDS, EPSILON, LocusWork } from "#compute/locus/job";
import type { LocusResult } from "#compute/results";
import type { PathPlan } from "#wasm/api";
import { cancel, epoch, sliceMilliseconds, submit } from "#workers/pool/engine";
import { single } from "#workers/pool/protocol";
import { preset } from "../../kit/frame/studio-link";
import type { Ends } from "../../kit/maps/morphs";

type DragonId = "dragon-3" | "terdragon" | "terdragon-mirrored";

export const DRAGONS: readonly { value: DragonId; label: string; about: string }[] = [
  {
    value: "dragon-3",
    label: "Heighway’s",
    about: "Heighway’s dragon of two maps, written with three: f₁, f₂f₁, f₂f₂",
  },
  {
    value: "terdragon",
    label: "Terdragon",
    about: "the terdragon λz, −iz/√3 + λ, λz + λ̄ with λ = ½ + i/(2√3)",
  },
  {
    value: "terdragon-mirrored",
    label: "Mirrored",
    about: "the terdragon’s mirror image: the same shape to look at, and another locus",
  },
];

export const dragon = signal<DragonId>("dragon-3");

export function aboutDragon(id: DragonId): string {
  return DRAGONS.find((one) => one.value === id)?.about ?? "";
}

export const ends: ReadonlySignal<Ends> = computed(() => ({
  from: preset(dragon.value).maps,
  to: preset("gasket").maps,
}));

/** All that is known of one pair. */
interface Chart {
  field: LocusResult | null;
  plan: PathPlan | null;
  problem: string | null;
}

const BLANK: Chart = { field: null, plan: null, problem: null };
const charts = signal<ReadonlyMap<DragonId, Chart>>(new Map());

export const chart: ReadonlySignal<Chart> = computed(() => charts.value.get(dragon.value) ?? BLANK);

function set(id: DragonId, change: Partial<Chart>): void {
  const before = charts.peek();
  charts.value = new Map(before).set(id, { ...(before.get(id) ?? BLANK), ...change });
}

/** At so many moments a path is checked: a break may be a thousandth of its length. */
const CHECKS = 2401;

const LOCUS = "figure:locus";
const PLAN = "figure:plan";

/** Keeps the chart of the chosen dragon coming, for as long as something shows it. Returns the end of it. */
export function followChart(): () => void {
  const stop = effect(() => {
    const id = dragon.value;
    epoch.value;
    untracked(() => {
      const now = charts.peek().get(id);
      if (now?.field?.progress !== 1 || now.plan === null) begin(id);
    });
  });
  return () => {
    stop();
    cancel(LOCUS);
    cancel(PLAN);
  };
}

function begin(id: DragonId): void {
  cancel(PLAN);
  const inputs = { ...ends.peek(), options: {} };
  let due = false;
  const work = new LocusWork(
    inputs,
    {
      // At most one new picture a frame.
      painted(now) {
        if (due) return;
        due = true;
        setTimeout(() => {
          due = false;
          set(id, { field: { ...now.filled, bounds: BOUNDS, progress: now.progress } });
        }, 60);
      },
      stage(now, stride) {
        if (stride === 1) plan(id, now);
      },
      failed(error) {
        cancel(LOCUS);
        set(id, { problem: error.message });
      },
    },
    sliceMilliseconds,
  );
  submit({ ...work.job(), channel: LOCUS });
}

function plan(id: DragonId, work: LocusWork): void {
  const { from, to } = work.inputs;
  const task = {
    kind: "plan" as const,
    locus: work.nested(1),
    bounds: BOUNDS,
    refine: { from, to, options: { epsilon: EPSILON, samples: CHECKS } },
  };
  const then = {
    accept: (found: PathPlan) => set(id, { plan: found }),
    fail: (error: { message: string }) => set(id, { problem: error.message }),
  };
  submit(single<"plan">(PLAN, 48, task, then));
}
