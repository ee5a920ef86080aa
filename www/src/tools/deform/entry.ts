import type { ToolEntry } from "#stage/tool";
import { loadBends } from "#wasm/bend";
import { keepPhase } from "./keep";

export const deform: ToolEntry = {
  id: "deform",
  label: "Deform",
  title: "Frond: bend a fractal by a grid",
  side: "Shape and grid",
  tool: () => Promise.all([import("./tool"), loadBends()]).then(([module]) => module.tool),
  keepOnUndo: keepPhase,
  missing: "The deformation grid could not be loaded",
};
