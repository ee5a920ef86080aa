import type { Keep } from "#document/history";
import type { ToolEntry } from "#stage/tool";
import { loadBends } from "#wasm/bend";
import * as messages from "./messages";

/** The moment of the grid. */
const keepPhase: Keep = (target, other, { deform }) =>
  target.deform && deform && target.deform.phase === other.deform?.phase
    ? { ...target, deform: { ...target.deform, phase: deform.phase } }
    : target;

export const deform: ToolEntry = {
  id: "deform",
  label: messages.deform,
  title: messages.frondDeformFractalWith,
  side: messages.shapeAndGrid,
  tool: () => Promise.all([import("./tool"), loadBends()]).then(([module]) => module.tool),
  keepOnUndo: keepPhase,
  missing: messages.deformationGridCouldNot,
};
