import { changeFit } from "#document/fit";
import { notify, wordsOf } from "#document/notice";
import type { OpenedSeries } from "#workers/fit/trace-types";
import { isTable, takeFile as takeTable } from "./graph/model/series";
import * as messages from "./messages";
import { graphOpen } from "./mode";
import { takeFile } from "./work/source";

/** What is to be fitted. While a graph is looked for, tables are series; whatever else there is has an outline. */
export function open(file: File): void {
  if (graphOpen.peek()) {
    if (isTable(file.name) || file.type.startsWith("text/")) {
      void takeTable(file);
      return;
    }
  }
  changeFit((fit) => (fit.mode === "outline" ? fit : { ...fit, mode: "outline" }));
  void takeFile(file, file.name, takeSeries);
}

/** Numbers that are a graph, not an outline, go to the other half of the tool. */
export function takeSeries(series: OpenedSeries): void {
  import("./graph/model/series").then(
    (graph) => {
      changeFit((now) => (now.mode === "graph" ? now : { ...now, mode: "graph" }));
      graph.takeSeries(series);
    },
    (problem) => notify({ kind: "error", text: messages.graphsNotLoaded(wordsOf(problem)) }),
  );
}
