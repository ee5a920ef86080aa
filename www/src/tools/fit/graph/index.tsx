/** The other half of the tool: the graph of a function, made by hand or found in what is measured. */
export { GraphPanel } from "./GraphPanel";
export { GraphStrip } from "./GraphStrip";
export { GraphStage } from "./stage/GraphStage";
