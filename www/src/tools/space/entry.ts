import type { ToolEntry } from "#stage/tool";
import { keepLook } from "./keep";

export const space: ToolEntry = {
  id: "space",
  label: "Space",
  title: "Frond: turn and move fractals in space",
  side: "Shapes, morph and light",
  stage: "Space",
  tool: () => import("./tool").then((module) => module.openTool()),
  keepOnUndo: keepLook,
  missing: "Space could not be loaded",
};
