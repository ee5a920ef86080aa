import graphCss from "../graph/graph.module.css";

/** The third part of the tool: curves of the plane, made by hand. */
export { PlanePanel } from "./PlanePanel";
export { PlaneStage } from "./stage/PlaneStage";

/** Where a graph has the hits of its clusters. */
export function PlaneStrip() {
  return (
    <div class={graphCss["graph-strip"]}>
      <p class="hint">
        Drag the points anywhere. The two arrows of a piece turn and lean its copy, inside the circle.
      </p>
    </div>
  );
}
