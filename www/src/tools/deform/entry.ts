import type { ToolEntry } from "#stage/tool";
import { loadBends } from "#wasm/bend";
import { keepPhase } from "./keep";
import * as messages from "./messages";

export const deform: ToolEntry = {
  id: "deform",
  label: messages.deform,
  title: messages.frondDeformFractalWith,
  side: messages.shapeAndGrid,
  tool: () => Promise.all([import("./tool"), loadBends()]).then(([module]) => module.tool),
  keepOnUndo: keepPhase,
  missing: messages.deformationGridCouldNot,
};
