import "./mesh/seen";
import "#ui/panel/panel.css";
import { ownColours } from "#document/colours";
import { ownWeights, standing } from "#document/morph";
import { scene } from "#document/scene";
import type { Tool } from "#stage/tool";
import { PanelFoot } from "#ui/panel/PanelFoot";
import { ColourPanel } from "./colour/ColourPanel";
import { commands, timeline } from "./commands";
import css from "./deform.module.css";
import { ringed, unbent } from "./facts";
import { films } from "./film";
import { GridPanel } from "./mesh/GridPanel";
import { DeformOverlay } from "./mesh/Overlay";
import * as messages from "./messages";
import { MotionPanel } from "./motion/MotionPanel";
import { openPhotograph } from "./picture/take";
import { BendPanel } from "./settings/BendPanel";
import { ContinuityFold, SpinFold } from "./settings/fields";
import { Gallery, ShapePanel } from "./shape/ShapePanel";
import { Start, StartOver } from "./start/Start";
import { Unbent } from "./start/Unbent";
import { DeformStrip } from "./strip/DeformStrip";

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

// The deformation tool: its side panel, its time strip, and what it lays over the picture. Loaded when it is first
// opened.

/** Everything beside the picture: what is bent, how its parts answer, how it moves, and its colours. */
export function DeformPanel() {
  if (unbent.value) {
    return (
      <>
        <Unbent />
        <Gallery />
      </>
    );
  }
  return (
    <div class={`panel ${css["deform-panel"]}`}>
      <ShapePanel />
      <Start />
      <BendPanel />
      <MotionPanel />
      <GridPanel />
      <ColourPanel />
      {ringed.value ? (
        <p class="hint">{messages.closedCurveHasNo}</p>
      ) : (
        <div class={css["folds"]}>
          <SpinFold />
          <ContinuityFold />
        </div>
      )}
      <PanelFoot>
        <StartOver />
      </PanelFoot>
      <Gallery />
    </div>
  );
}
