import "#ui/panel/panel.css";
import "./fit.module.css";
import { effect } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Tool } from "#stage/tool";
import { narrow } from "#ui/media";
import { PanelFoot } from "#ui/panel/PanelFoot";
import { loadCurves } from "#wasm/curve";
import { fitTask } from "#workers/fit/client";
import { commands } from "./commands";
import { CopiesPanel } from "./copies/CopiesPanel";
import { KeptPanel } from "./kept/KeptPanel";
import {
  GraphPanel,
  GraphStage,
  GraphStrip,
  graphOpen,
  ModeChoice,
  PlanePanel,
  PlaneStage,
  PlaneStrip,
  planeOpen,
} from "./mode";
import { open } from "./open";
import { CutPanel } from "./panel/CutPanel";
import { FiguresPanel } from "./panel/FiguresPanel";
import { ModelPanel } from "./panel/ModelPanel";
import { OutlinePanel } from "./panel/OutlinePanel";
import { SourcePanel } from "./panel/SourcePanel";
import { UsePanel } from "./panel/UsePanel";
import { savePng } from "./save";
import { hand } from "./stage/brush";
import { FitStage as OutlineStage } from "./stage/FitStage";
import { cutting, step } from "./stage/layers";
import { watchFeatures } from "./stage/sight";
import { FitStrip as OutlineStrip } from "./strip/FitStrip";
import { Layers } from "./strip/Layers";
import { watchUse } from "./use";
import { watchFit } from "./work/fitting";
import { watchMask } from "./work/mask";
import { watchOutline } from "./work/outline";
import { opened } from "./work/source";

// The fit: its side panel, its strip, and its stage. Loaded when it is first opened.

/** Everything beside the picture: what is fitted, with what, how near it is, and where it goes. */
export function FitPanel() {
  return (
    <div class="panel">
      <ModeChoice />
      {graphOpen.value ? <GraphPanel /> : planeOpen.value ? <PlanePanel /> : <Outline />}
    </div>
  );
}

function Outline() {
  useEffect(() => {
    // The workers come up while the page is laid out.
    for (const lane of [0, 1] as const) fitTask("wake", {}, { lane }).catch(() => {});
    const stops = [watchMask(), watchOutline(), watchFit(), watchUse(), watchStep(), watchFeatures()];
    return () => {
      for (const stop of stops) stop();
    };
  }, []);
  return (
    <>
      {/* What is to be done now comes first. */}
      {cutting.value ? (
        <>
          <CutPanel />
          <SourcePanel />
        </>
      ) : (
        <>
          <SourcePanel />
          <CutPanel />
        </>
      )}
      {/* Where it goes stands above all that can be read of it. */}
      <UsePanel />
      <OutlinePanel />
      <ModelPanel />
      <FiguresPanel />
      <CopiesPanel />
      <KeptPanel />
      {narrow.value && <Layers />}
      <PanelFoot />
    </>
  );
}

/** A picture that has just come is cut out first. */
let last: number | null = null;

function watchStep(): () => void {
  return effect(() => {
    const id = opened.value?.id ?? null;
    if (id === last) return;
    last = id;
    step.value = "cut";
    hand.value = "move";
  });
}

export function FitStrip() {
  if (planeOpen.value) return <PlaneStrip />;
  return graphOpen.value ? <GraphStrip /> : <OutlineStrip />;
}

export function FitStage() {
  if (planeOpen.value) return <PlaneStage />;
  return graphOpen.value ? <GraphStage /> : <OutlineStage />;
}

/** With what makes closed curves and graphs. */
export async function openTool(): Promise<Tool> {
  await loadCurves();
  return { Stage: FitStage, Panel: FitPanel, Strip: FitStrip, commands, open, savePng };
}
