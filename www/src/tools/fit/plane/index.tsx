/** The third part of the tool: curves of the plane, made by hand. */
export { PlanePanel } from "./PlanePanel";
export { PlaneStrip } from "./PlaneStrip";
export { PlaneStage } from "./stage/PlaneStage";
