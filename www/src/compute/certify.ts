/** How wide a gap a path can have at most, proved part by part. */
import { computed, effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import { pathPoints } from "#document/morph";
import { wordsOf } from "#document/notice";
import type { Uv } from "#geometry/path";
import type { PathCertificate } from "#wasm/api";
import { cancel, epoch, submit } from "#workers/pool/engine";
import type { Job, Task } from "#workers/pool/protocol";
import { inputs as morph } from "./inputs";
import { EPSILON, type LocusInputs } from "./locus/job";
import { along } from "./results";

/** Parts that a path is proved in: enough for all workers, and for a bar that moves. */
export const PARTS = 48;
/** Boxes that are looked at in one part: where so many do not suffice, more seldom help. */
const BUDGET = 1500;
/** More than the widest gap that samples met: the bound lies above what is true. */
const ABOVE_SAMPLES = 1.15;

/** What is proved of a whole path, as far as it is. */
export interface Certified {
  points: readonly Uv[];
  inputs: LocusInputs;
  /** The relative gap that was to be excluded. */
  within: number;
  /** Parts that are done, and all of them. */
  done: number;
  parts: number;
  /** No wider gap anywhere on the parts that are done; Infinity where nothing could be proved. */
  gap: number;
  boxes: number;
  /** Joints of pieces that the bound rests on, instead of boxes. */
  joints: number;
  /** Where the least could be proved. */
  worst: number;
  /** Whether all of it is within what was asked for. */
  holds: boolean;
  /** Why it cannot be had, in words. */
  problem: string | null;
}

const latest = signal<Certified | null>(null);

/** About the present path; null where nothing was asked since it last changed. */
export const certified: ReadonlySignal<Certified | null> = computed(() => {
  const found = latest.value;
  return found && found.points === pathPoints.value && found.inputs === morph.value ? found : null;
});

/** One part more. Parts may come in any order. */
export function joined(so: Certified, part: PathCertificate): Certified {
  return {
    ...so,
    done: so.done + 1,
    gap: Math.max(so.gap, part.gap),
    boxes: so.boxes + part.boxes,
    joints: Math.max(so.joints, part.joints),
    worst: part.gap > so.gap ? part.worst : so.worst,
    holds: so.holds && part.holds,
  };
}

/** Proves what can be proved of the present path: in parts, on all workers. */
export function certify(): void {
  const inputs = morph.peek();
  const points = pathPoints.peek();
  const met = along.peek()?.worst?.gap ?? 0;
  const within = Math.max(EPSILON, ABOVE_SAMPLES * met);
  latest.value = {
    points,
    inputs,
    within,
    done: 0,
    parts: PARTS,
    gap: 0,
    boxes: 0,
    joints: 0,
    worst: 0,
    holds: true,
    problem: null,
  };
  submit(certifyJob(points, inputs, within));
}

function certifyJob(points: Uv[], inputs: LocusInputs, within: number): Job<"certify"> {
  let part = 0;
  const stop = (problem: string) => {
    const so = latest.peek();
    if (so?.points !== points) return;
    cancel("certify");
    latest.value = { ...so, problem };
  };
  return {
    channel: "certify",
    priority: () => 12,
    next() {
      if (part >= PARTS) return null;
      const t0 = part / PARTS;
      const t1 = ++part / PARTS;
      const options = { ...inputs.options, within, t0, t1, budget: BUDGET };
      const task: Task<"certify"> = { kind: "certify", from: inputs.from, to: inputs.to, points, options };
      return task;
    },
    accept(_, result) {
      const so = latest.peek();
      if (so?.points === points) latest.value = joined(so, result);
    },
    fail: (_, error) => stop(wordsOf(error)),
  };
}

export function stopCertifying(): void {
  cancel("certify");
  latest.value = null;
}

/** A proof is about one path of one pair: it ends with them. */
export function scheduleCertify(): void {
  effect(() => {
    pathPoints.value;
    morph.value;
    untracked(() => {
      if (latest.peek() && !certified.peek()) stopCertifying();
    });
  });
  effect(() => {
    epoch.value;
    // Another host: what was under way has to be asked again, by hand.
    untracked(() => {
      const so = latest.peek();
      if (so && so.done < so.parts) stopCertifying();
    });
  });
}
