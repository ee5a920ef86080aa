import type { ToolEntry } from "#stage/tool";

export const fit: ToolEntry = {
  id: "fit",
  label: "Fit",
  title: "Frond: find the formula of an outline",
  side: "Outline and fit",
  stage: "Outline",
  tool: () => import("./tool").then((module) => module.openTool()),
  missing: "The fit could not be loaded",
};
