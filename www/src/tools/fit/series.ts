/** Numbers that are a graph, not an outline, go to the other half of the tool. */

import { changeFit } from "#document/fit";
import { notify, wordsOf } from "#document/notice";
import type { OpenedSeries } from "#workers/fit/trace-types";
import * as messages from "./messages";

export function takeSeries(series: OpenedSeries): void {
  import("./graph/model/series").then(
    (graph) => {
      changeFit((now) => (now.mode === "graph" ? now : { ...now, mode: "graph" }));
      graph.takeSeries(series);
    },
    (problem) => notify({ kind: "error", text: messages.graphsNotLoaded(wordsOf(problem)) }),
  );
}
