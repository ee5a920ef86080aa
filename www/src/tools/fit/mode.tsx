/** An outline, a graph or a curve: three parts of one tool, of which two are loaded when they are first opened. */
import { computed, effect, type Signal, signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { changeFit, fitDocument } from "#document/fit";
import { notify, wordsOf } from "#document/notice";
import { Segmented } from "#ui/controls/Segmented";

export const graphOpen = computed(() => fitDocument.value.mode === "graph");
export const planeOpen = computed(() => fitDocument.value.mode === "plane");

const graph = signal<typeof import("./graph/index") | null>(null);
const plane = signal<typeof import("./plane/index") | null>(null);

function load<T>(part: Signal<T | null>, name: string, get: () => Promise<T>): void {
  if (part.peek()) return;
  get().then(
    (module) => {
      part.value = module;
    },
    (problem) => notify({ kind: "error", text: `${name} could not be loaded: ${wordsOf(problem)}` }),
  );
}

export function ModeChoice() {
  useEffect(
    () =>
      effect(() => {
        if (graphOpen.value) load(graph, "Graphs", () => import("./graph/index"));
        if (planeOpen.value) load(plane, "Curves of the plane", () => import("./plane/index"));
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
        { value: "plane", label: "A curve", description: "A fractal curve through points of the plane" },
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

export function PlanePanel() {
  const Plane = plane.value;
  return Plane && <Plane.PlanePanel />;
}

export function PlaneStrip() {
  const Plane = plane.value;
  return Plane && <Plane.PlaneStrip />;
}

export function PlaneStage() {
  const Plane = plane.value;
  return Plane && <Plane.PlaneStage />;
}
