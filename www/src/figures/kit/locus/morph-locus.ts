/** The locus of a pair of shapes as a lesson shows it: one size, all of the square, in rows. */
import { useEffect, useState } from "preact/hooks";
import { BOUNDS, EPSILON, nextKey } from "#compute/locus/job";
import type { LocusResult } from "#compute/results";
import { STATE } from "#geometry/states";
import type { MorphOptions } from "#wasm/api";
import { epoch, submit } from "#workers/pool/engine";
import type { Channel, Job, Task } from "#workers/pool/protocol";
import type { Ends } from "../maps/morphs";
import { useChannel, useValue } from "../workers";

/** Rows in one slice. */
const ROWS = 8;

interface ChartWish {
  ends: Ends;
  options: MorphOptions;
  /** Samples a side: 3 k + 1, so that both ends are samples. */
  size: number;
}

/** A locus without samples. */
export function blankChart(size: number): LocusResult {
  return {
    width: size,
    height: size,
    state: new Uint8Array(size * size).fill(STATE.pending),
    gap: new Float32Array(size * size).fill(Number.NaN),
    progress: 0,
    bounds: BOUNDS,
  };
}

/** The locus as far as it is known; null while nothing is asked for. */
export function useChart(wish: ChartWish | null): LocusResult | null {
  const channel = useChannel();
  const host = useValue(epoch);
  const [chart, setChart] = useState<{ of: ChartWish; field: LocusResult } | null>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: a new host has to be asked anew
  useEffect(() => {
    if (wish) submit(chartJob(channel, wish, (field) => setChart({ of: wish, field })));
  }, [channel, wish, host]);
  return chart && chart.of === wish ? chart.field : null;
}

export function chartJob(
  channel: Channel,
  { ends, options, size }: ChartWish,
  show: (field: LocusResult) => void,
): Job<"locus"> {
  const key = nextKey();
  const field = blankChart(size);
  let row = 0;
  let done = 0;
  return {
    channel,
    priority: () => 38,
    next() {
      if (row >= size) return null;
      const r0 = row;
      row = Math.min(size, row + ROWS);
      const grid = { ...options, epsilon: EPSILON, bounds: BOUNDS, width: size, height: size };
      return { kind: "locus", key, ...ends, options: grid, r0, r1: row, stride: 1, first: true };
    },
    accept({ r0, r1 }: Task<"locus">, { state, gap }) {
      field.state.set(state.subarray(0, (r1 - r0) * size), r0 * size);
      field.gap.set(gap.subarray(0, (r1 - r0) * size), r0 * size);
      done += r1 - r0;
      show({ ...field, progress: done / size });
    },
    // Rows that cannot be done stay blank.
    fail(task) {
      done += task.r1 - task.r0;
      show({ ...field, progress: done / size });
    },
  };
}
