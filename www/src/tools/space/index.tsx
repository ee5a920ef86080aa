/** Space: its stage, its side panel and its strip. Loaded when it is first opened. */
import "#ui/panel/panel.css";
import { effect } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { spaceShown } from "#document/playback";
import { Segmented } from "#ui/controls/Segmented";
import { PanelFoot } from "#ui/panel/PanelFoot";
import { BendPanel3 } from "./bend/BendPanel3";
import { LightPanel } from "./light/LightPanel";
import * as messages from "./messages";
import { MorphPanel3 } from "./morph/MorphPanel3";
import { watchMorph } from "./morph/work";
import { type Part, part } from "./part";
import { ShapePanel } from "./shape/ShapePanel";
import css from "./space.module.css";
import { spaceDrawn } from "./stage/state";
import { TimePanel } from "./time/TimePanel";

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
