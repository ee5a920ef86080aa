import { openSpace } from "#document/space/space";
import type { Tool } from "#stage/tool";
import { commands, timeline } from "./commands";
import { films, still } from "./film";
import { SpacePanel } from "./index";
import { savePng } from "./save";
import { SpaceStage } from "./stage/SpaceStage";
import { TimeStrip } from "./time/TimeStrip";

/** With what computes it. */
export async function openTool(): Promise<Tool> {
  await openSpace();
  return {
    Stage: SpaceStage,
    Panel: SpacePanel,
    Strip: TimeStrip,
    timeline,
    commands: () => commands,
    savePng,
    still,
    films,
  };
}
