import { useEffect, useMemo, useState } from "preact/hooks";
import { BOUNDS, EPSILON, nextKey } from "#compute/locus/job";
import type { LocusResult } from "#compute/results";
import { epoch, submit } from "#workers/pool/engine";
import { single } from "#workers/pool/protocol";
import { useChart } from "../../kit/locus/morph-locus";
import { useChannel, useValue } from "../../kit/workers";
import { ends } from "./map";

/** Samples a side. */
export const SIZE = 91;

/** The map, and then the same with what can be proved of it; null while it is not wanted. */
export function useProved(wanted: boolean): { field: LocusResult | null; proved: boolean } {
  const wish = useMemo(() => (wanted ? { ends: ends(), options: {}, size: SIZE } : null), [wanted]);
  const field = useChart(wish);
  const channel = useChannel();
  const host = useValue(epoch);
  const [done, setDone] = useState<{ of: LocusResult; field: LocusResult } | null>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: a new host has to be asked anew
  useEffect(() => {
    if (field?.progress !== 1) return;
    const { from, to } = ends();
    const grid = { epsilon: EPSILON, bounds: BOUNDS, width: SIZE, height: SIZE };
    const of = { from, to, options: grid };
    const all = { x0: 0, y0: 0, x1: SIZE, y1: SIZE };
    submit(
      single<"prove">(
        channel,
        36,
        { kind: "prove", key: nextKey(), of, ...all, state: field.state },
        {
          accept: (state) => setDone({ of: field, field: { ...field, state } }),
          // What is not proved stays as it was.
          fail: () => setDone({ of: field, field }),
        },
      ),
    );
  }, [field, channel, host]);
  const proved = done !== null && done.of === field;
  return { field: proved ? done.field : field, proved };
}
