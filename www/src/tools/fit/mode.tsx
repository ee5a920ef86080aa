/** An outline or a graph: two halves of one tool, of which the second is loaded when it is first opened. */
import { computed, effect, signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { changeFit, fitDocument } from "#document/fit";
import { notify, wordsOf } from "#document/notice";
import { Segmented } from "#ui/controls/Segmented";

export const graphOpen = computed(() => fitDocument.value.mode === "graph");

const graph = signal<typeof import("./graph/index") | null>(null);

function load(): void {
  if (graph.peek()) return;
  import("./graph/index").then(
    (module) => {
      graph.value = module;
    },
    (problem) => notify({ kind: "error", text: `Graphs could not be loaded: ${wordsOf(problem)}` }),
  );
}

export function ModeChoice() {
  useEffect(
    () =>
      effect(() => {
        if (graphOpen.value) load();
      }),
    [],
  );
  return (
    <Segmented
      label="What is fitted"
      value={fitDocument.value.mode}
      options={[
        { value: "outline", label: "An outline", description: "A leaf, a coast: a closed curve" },
        { value: "graph", label: "A graph", description: "A profile, a time series: a function" },
      ]}
      onChange={(mode) => changeFit((now) => ({ ...now, mode }))}
    />
  );
}

export function GraphPanel() {
  const Graph = graph.value;
  return Graph && <Graph.GraphPanel />;
}

export function GraphStrip() {
  const Graph = graph.value;
  return Graph && <Graph.GraphStrip />;
}

export function GraphStage() {
  const Graph = graph.value;
  return Graph && <Graph.GraphStage />;
}
