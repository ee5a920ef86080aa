import { useEffect } from "preact/hooks";
import { changeFit } from "#document/fit";
import { listenForFiles } from "#ui/files/dropFiles";
import { takeSeries } from "../series";
import { takeFile as takeOutlineFile } from "../work/source";
import { FindSection } from "./find/Find";
import { FoundSection } from "./find/Found";
import css from "./graph.module.css";
import { isTable, takeFile } from "./model/series";
import { FunctionSection } from "./Pieces";

/** The function by hand, and how one is found in what is measured. */
export function GraphPanel() {
  useEffect(() => listenForFiles(([file]) => take(file)), []);
  return (
    <div class={css["fit-graph-panel"]}>
      <FindSection />
      <FoundSection />
      <FunctionSection />
    </div>
  );
}

/** What is no table of numbers goes to the other half of the tool. */
function take(file: File): void {
  if (isTable(file.name) || file.type.startsWith("text/")) {
    void takeFile(file);
    return;
  }
  changeFit((fit) => ({ ...fit, mode: "outline" }));
  void takeOutlineFile(file, file.name, takeSeries);
}
