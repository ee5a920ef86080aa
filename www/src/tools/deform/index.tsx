/**
 * The deformation tool: its side panel, its time strip, and what it lays over the picture. Loaded when it is first
 * opened.
 */
import { PanelFoot } from "#ui/panel/PanelFoot";
import { ColourPanel } from "./colour/ColourPanel";
import { ringed, unbent } from "./facts";
import { GridPanel } from "./mesh/GridPanel";
import { MotionPanel } from "./motion/MotionPanel";
import { BendPanel } from "./settings/BendPanel";
import { ContinuityFold, SpinFold } from "./settings/Folds";
import { Gallery, ShapePanel } from "./shape/ShapePanel";
import { Start, StartOver } from "./start/Start";
import { Unbent } from "./start/Unbent";
import "#ui/panel/panel.css";
import css from "./deform.module.css";
import * as messages from "./messages";

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
