import { ownColours } from "#document/colours";
import { standing } from "#document/morph";
import { ownWeights } from "#document/own-weights";
import { scene } from "#document/scene";
import type { Tool } from "#stage/tool";
import { commands, timeline } from "./commands";
import { films } from "./film";
import { DeformPanel } from "./index";
import { DeformOverlay } from "./mesh/Overlay";
import "./mesh/seen";
import * as messages from "./messages";
import { DeformStrip } from "./strip/DeformStrip";
import { openPhotograph } from "./subject";

export const tool: Tool = {
  Overlay: DeformOverlay,
  Panel: DeformPanel,
  Strip: DeformStrip,
  timeline,
  commands: () => commands,
  films,
  maps: () => [
    {
      label: messages.shape,
      name: scene.peek().a.name,
      maps: standing.peek(),
      weights: ownWeights.peek(),
      palette: ownColours(scene.peek()),
    },
  ],
  open: openPhotograph,
};
