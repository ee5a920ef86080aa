import type { Tool } from "#stage/tool";
import { loadCurves } from "#wasm/curve";
import { commands } from "./commands";
import { FitPanel, FitStage, FitStrip } from "./index";
import { open } from "./open";
import { savePng } from "./save";

/** With what makes closed curves and graphs. */
export async function openTool(): Promise<Tool> {
  await loadCurves();
  return { Stage: FitStage, Panel: FitPanel, Strip: FitStrip, commands, open, savePng };
}
