import type { Intersection3 } from "#wasm/api";
import { StateGraph } from "../graph/state-graph";
import { graphWords, pairWords, waysOf } from "./meets";

/** The shifts by which the shapes reach each other, and the pairs of maps that lead from one to the next. */
export function MeetGraph({ found }: { found: Pick<Intersection3, "shifts" | "arrows"> }) {
  const ways = waysOf(found).map(({ from, to, pairs }) => ({ from, to, label: pairWords(pairs) }));
  return <StateGraph count={found.shifts.length} ways={ways} words={graphWords(found)} />;
}
