import { useMemo } from "preact/hooks";
import { TABLE_1 as TABLE_1_GRAPH } from "#tools/fit/graph/printed";
import { loadCurves, rough } from "#wasm/curve";
import type { Line } from "../graphs/profile";
import { Still } from "../graphs/still";

/** What must be there before it is drawn. */
export const needs = [loadCurves];

export function Thumb() {
  const lines = useMemo(
    (): Line[] => [
      {
        points: rough.sampleGraph(TABLE_1_GRAPH, { tolerance: 0.01, most: 4000 }),
        colour: "ink",
        width: 1.1,
      },
    ],
    [],
  );
  return <Still lines={lines} t={[-1, 1]} />;
}
