/** The morph tool: its side panel and its time strip. */
import { stuck } from "#compute/results";
import { selection } from "#document/morph";
import { standIn } from "#document/stand-in";
import { narrow } from "#ui/media";
import { PanelFoot } from "#ui/panel/PanelFoot";
import { gallery, orbitOpen } from "./dialogs";
import { Gallery, MapEditor, MotionPanel, OrbitPanel, OtherWays, StandIn } from "./later";
import { LocusBeside, LocusPanel } from "./locus/LocusPanel";
import { PathPanel } from "./locus/path/PathPanel";
import { family } from "./locus/view/view";
import { PairNotes, PairsPanel } from "./pairs/PairsPanel";
import { Ends } from "./shapes/Ends";
import { PlaybackOptions } from "./strip/MorphStrip";
import "#ui/panel/panel.css";
import * as messages from "./messages";
import css from "./morph.module.css";

/** Everything beside the picture: the shapes and the way between both. */
export function MorphPanel() {
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
