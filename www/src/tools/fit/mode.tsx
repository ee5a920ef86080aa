/** An outline, a graph or a curve: three parts of one tool, of which two are loaded when they are first opened. */
import { computed, effect, type Signal, signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { changeFit, fitDocument } from "#document/fit";
import { notify, wordsOf } from "#document/notice";
import { Segmented } from "#ui/controls/Segmented";
import * as messages from "./messages";

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
    (problem) => notify({ kind: "error", text: messages.notLoaded(name, wordsOf(problem)) }),
  );
}

export function ModeChoice() {
  useEffect(
    () =>
      effect(() => {
        if (graphOpen.value) load(graph, messages.graphs, () => import("./graph/index"));
        if (planeOpen.value) load(plane, messages.curvesPlane, () => import("./plane/index"));
      }),
    [],
  );
  return (
    <Segmented
      label={messages.fit2}
      value={fitDocument.value.mode}
      options={[
        { value: "outline", label: messages.outline3, description: messages.leafCoastClosedCurve },
        { value: "graph", label: messages.graph, description: messages.profileTimeSeriesFunction },
        { value: "plane", label: messages.curve, description: messages.fractalCurveThroughPoints },
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
