import { useMemo } from "preact/hooks";
import { loadCurves, rough } from "#wasm/curve";
import { byPiece } from "../graphs/graphs";
import { Still } from "../graphs/still";
import { FIGURE_1, interpolated } from "./interpolation";

/** What must be there before it is drawn. */
export const needs = [loadCurves];

export function Thumb() {
  const lines = useMemo(() => {
    const graph = interpolated(FIGURE_1.points, FIGURE_1.c);
    const samples = rough.sampleGraph(graph, { tolerance: 0.01, most: 4000 });
    return byPiece(graph, samples).map((points, colour) => ({ points, colour, width: 1.25 }));
  }, []);
  return <Still lines={lines} t={[0, 1]} />;
}
