import { openSpace } from "#document/space/space";
import type { Tool } from "#stage/tool";
import { commands, timeline } from "./commands";
import { films, still } from "./film";
import { SpacePanel } from "./index";
import { MeshDialog } from "./mesh/MeshDialog";
import * as messages from "./messages";
import { savePng } from "./save";
import { object, parameters } from "./shape/now";
import { SpaceStage } from "./stage/SpaceStage";
import { takeAnimation } from "./time/saved/open";
import { TimeStrip } from "./time/TimeStrip";

/** The object that is worked on, as it is now. */
const maps = () => [
  { label: messages.object2, name: object.peek()?.name ?? messages.shape, maps: parameters.peek() },
];

/** With what computes it. */
export async function openTool(): Promise<Tool> {
  await openSpace();
  return {
    Stage: SpaceStage,
    Panel: SpacePanel,
    Strip: TimeStrip,
    timeline,
    commands: () => commands,
    maps,
    open: takeAnimation,
    savePng,
    MeshDialog,
    still,
    films,
  };
}
