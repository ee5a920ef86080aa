import { FindSection } from "./find/Find";
import { FoundSection } from "./find/Found";
import css from "./graph.module.css";
import { FunctionSection } from "./Pieces";

/** The function by hand, and how one is found in what is measured. */
export function GraphPanel() {
  return (
    <div class={css["fit-graph-panel"]}>
      <FindSection />
      <FoundSection />
      <FunctionSection />
    </div>
  );
}
