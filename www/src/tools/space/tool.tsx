import "#ui/panel/panel.css";
import { effect } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { spaceShown } from "#document/playback";
import { openSpace } from "#document/space/space";
import type { Tool } from "#stage/tool";
import { Segmented } from "#ui/controls/Segmented";
import { PanelFoot } from "#ui/panel/PanelFoot";
import { BendPanel3 } from "./bend/BendPanel3";
import { commands, timeline } from "./commands";
import { films, still } from "./film";
import { LightPanel } from "./light/LightPanel";
import { MeshDialog } from "./mesh/MeshDialog";
import * as messages from "./messages";
import { MorphPanel3 } from "./morph/MorphPanel3";
import { watchMorph } from "./morph/work";
import { savePng } from "./save";
import { object, parameters } from "./shape/now";
import { ShapePanel } from "./shape/ShapePanel";
import css from "./space.module.css";
import { SpaceStage } from "./stage/SpaceStage";
import { type Part, part, spaceDrawn } from "./stage/state";
import { takeAnimation } from "./time/saved/open";
import { TimePanel } from "./time/TimePanel";
import { TimeStrip } from "./time/TimeStrip";

// Space: its stage, its side panel and its strip. Loaded when it is first opened.

effect(() => {
  spaceShown.value = spaceDrawn.value;
});

const PARTS: { value: Part; label: string; description: string }[] = [
  { value: "shape", label: messages.shape, description: messages.objectsTheirParametersAnd },
  { value: "bend", label: messages.deform2, description: messages.latticeDeformsObjectAt },
  { value: "morph", label: messages.morph, description: messages.anotherShapeFirstObject },
  { value: "light", label: messages.light, description: messages.lightColoursAndView },
  { value: "time", label: messages.time, description: messages.keyframesAndFilms },
];

/** Everything beside the picture. */
export function SpacePanel() {
  useEffect(() => {
    // A path is looked for whichever part is open.
    const stop = watchMorph();
    const toShape = (event: DragEvent) => {
      if (event.dataTransfer?.types.includes(messages.files)) part.value = "shape";
    };
    addEventListener("drop", toShape);
    return () => {
      removeEventListener("drop", toShape);
      stop();
    };
  }, []);
  const now = part.value;
  return (
    <div class={`panel ${css["space-panel"]}`}>
      <Segmented
        label={messages.panel}
        value={now}
        options={PARTS}
        onChange={(next) => {
          part.value = next;
        }}
      />
      {now === "shape" && <ShapePanel />}
      {now === "bend" && <BendPanel3 />}
      {now === "morph" && <MorphPanel3 />}
      {now === "light" && <LightPanel />}
      {now === "time" && <TimePanel />}
      <PanelFoot />
    </div>
  );
}

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
