import { useMemo } from "preact/hooks";
import { TABLE_3 as TABLE_3_GRAPH } from "#tools/fit/graph/printed";
import { loadCurves, rough } from "#wasm/curve";
import { heightsAlong, TOP } from "../graphs/arrowhead";
import { byPiece } from "../graphs/graphs";
import type { Line } from "../graphs/profile";
import { Still } from "../graphs/still";

/** What must be there before it is drawn. */
export const needs = [loadCurves];

/** The seven maps over what they were found for. */
export function Thumb() {
  const lines = useMemo((): Line[] => {
    const samples = rough.sampleGraph(TABLE_3_GRAPH, { tolerance: 0.01, most: 4000 });
    return [
      { points: heightsAlong(5, TOP), colour: "quiet", width: 1 },
      ...byPiece(TABLE_3_GRAPH, samples).map((points, i) => ({ points, colour: i % 2, width: 1.25 })),
    ];
  }, []);
  return <Still lines={lines} t={[0, 1]} />;
}
