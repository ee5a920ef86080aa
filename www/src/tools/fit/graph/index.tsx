/** The other half of the tool: the graph of a function, made by hand or found in what is measured. */
export { GraphPanel } from "./GraphPanel";
export { GraphStage } from "./GraphStage";
export { GraphStrip } from "./GraphStrip";
