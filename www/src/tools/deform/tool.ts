import type { Tool } from "#stage/tool";
import { commands, timeline } from "./commands";
import { films } from "./film";
import { DeformPanel } from "./index";
import { DeformOverlay } from "./mesh/Overlay";
import { DeformStrip } from "./strip/DeformStrip";

export const tool: Tool = {
  Overlay: DeformOverlay,
  Panel: DeformPanel,
  Strip: DeformStrip,
  timeline,
  commands: () => commands,
  films,
};
