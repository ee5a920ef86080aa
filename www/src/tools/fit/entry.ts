import type { ToolEntry } from "#stage/tool";
import * as messages from "./messages";

export const fit: ToolEntry = {
  id: "fit",
  label: messages.fit,
  title: messages.frondFindFormulaOutline,
  side: messages.outlineAndFit,
  stage: messages.outline,
  tool: () => import("./tool").then((module) => module.openTool()),
  missing: messages.fitCouldNotLoaded,
};
