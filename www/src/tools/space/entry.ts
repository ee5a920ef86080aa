import type { ToolEntry } from "#stage/tool";
import { keepLook } from "./keep";
import * as messages from "./messages";

export const space: ToolEntry = {
  id: "space",
  label: messages.space,
  title: messages.frondRotateAndMove,
  side: messages.shapesMorphAndLight,
  stage: messages.space,
  tool: () => import("./tool").then((module) => module.openTool()),
  keepOnUndo: keepLook,
  missing: messages.spaceCouldNotLoaded,
};
