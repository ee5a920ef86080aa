import "#ui/panel/panel.css";
import { computed } from "@preact/signals";
import { told } from "#compute/proof";
import { stuck, verdict } from "#compute/results";
import { selection } from "#document/morph";
import { playing } from "#document/playback";
import { standIn } from "#document/stand-in";
import { type VerdictWords, verdictLine, verdictWords } from "#format/verdict";
import { useSaidAtRest } from "#stage/evidence/aloud";
import { VerdictChip } from "#stage/evidence/Chip";
import { evidenceOpen } from "#stage/evidence/shown";
import { MapOverlay } from "#stage/stage";
import type { ToolEntry } from "#stage/tool";
import { narrow } from "#ui/media";
import { PanelFoot } from "#ui/panel/PanelFoot";
import { commands, timeline } from "./commands";
import { CHIP_ID, gallery, orbitOpen, PANEL_ID } from "./dialogs";
import { namedMaps } from "./document-signals";
import {
  fetchAhead,
  Gallery,
  MapEditor,
  MorphEvidence,
  MotionPanel,
  OrbitOverlay,
  OrbitPanel,
  OtherWays,
  StandIn,
} from "./later";
import { LocusBeside, LocusPanel } from "./locus/LocusPanel";
import { PathPanel } from "./locus/path/PathPanel";
import { family } from "./locus/view/view";
import * as messages from "./messages";
import css from "./morph.module.css";
import { PairNotes, PairsPanel } from "./pairs/PairsPanel";
import { Ends } from "./shapes/Ends";
import { MorphStrip, PlaybackOptions } from "./strip/MorphStrip";

const words = computed<VerdictWords>(() => verdictWords(told.value, verdict.value?.epsilon));

/** What holds for the picture on the stage, in words; pressed, it tells why. */
function MorphChip() {
  useSaidAtRest(() => ({
    text: verdict.value ? verdictLine(told.value, verdict.value.epsilon) : "",
    moving: playing.value || verdict.value?.stale !== false,
  }));
  const stale = verdict.value?.stale ?? false;
  return <VerdictChip id={CHIP_ID} panel={PANEL_ID} stale={stale} words={words.value} />;
}

export const morph: ToolEntry = {
  id: "morph",
  label: messages.morph2,
  title: messages.frondMorphOneFractal,
  side: messages.shapesAndPath,
  tool: {
    Overlay: () => (
      <>
        <MapOverlay />
        {orbitOpen.value && !standIn.value && <OrbitOverlay />}
      </>
    ),
    Verdict: () => (standIn.value ? <StandIn part="chip" /> : <MorphChip />),
    Evidence: () => (standIn.value ? <StandIn part="evidence" /> : evidenceOpen.value && <MorphEvidence />),
    Panel: MorphPanel,
    Strip: MorphStrip,
    timeline,
    commands: () => commands,
    films: () => import("./film").then((module) => module.films()),
    maps: namedMaps,
  },
  fetchAhead,
};

// The morph tool: its side panel and its time strip.

/** Everything beside the picture: the shapes and the way between both. */
function MorphPanel() {
  return (
    <div class="panel">
      {standIn.value ? <StandIn part="panel" /> : <Systems />}
      {standIn.value && narrow.value && <PlaybackOptions />}
      <PanelFoot />
      {gallery.value !== null && <Gallery />}
    </div>
  );
}

/** Two systems, then either the maps of one of them or the way between both. */
function Systems() {
  const editing = selection.value;
  return (
    <>
      {/* What is worked on stands on top. */}
      {orbitOpen.value && <OrbitPanel />}
      {editing !== null && (
        <MapEditor
          key={editing.target}
          target={editing.target}
          chosen={editing.map}
          whole={editing.whole ?? false}
        />
      )}
      {(editing !== null || family.value === "morph") && <Ends key="ends" />}
      {editing === null ? <Morph /> : <LocusBeside />}
    </>
  );
}

/** Where the way breaks: what else there is, above all that it is about. */
function Cure() {
  if (!stuck.value) return null;
  return (
    <section class={css["cure"]} aria-label={messages.otherPaths}>
      <p>{messages.thisPathFallsApart}</p>
      <OtherWays />
    </section>
  );
}

function Morph() {
  // Of another family's map the two shapes, the path and its time are no part.
  if (family.value === "polygon") return <LocusPanel />;
  return (
    <>
      <PairNotes />
      <Cure />
      <LocusPanel />
      <PathPanel />
      <MotionPanel />
      {narrow.value && <PlaybackOptions />}
      <PairsPanel />
    </>
  );
}
