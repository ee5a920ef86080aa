import type { ToolEntry } from "#stage/tool";
import { keepPhase } from "./keep";

export const deform: ToolEntry = {
  id: "deform",
  label: "Deform",
  title: "Frond: bend a fractal by a grid",
  side: "Shape and grid",
  tool: () => import("./tool").then((module) => module.tool),
  keepOnUndo: keepPhase,
  missing: "The deformation grid could not be loaded",
};
