import { changeFit } from "#document/fit";
import { isTable, takeFile as takeTable } from "./graph/model/series";
import { graphOpen } from "./mode";
import { takeSeries } from "./series";
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
