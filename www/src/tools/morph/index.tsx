/** The morph tool: its side panel and its time strip. */
import { useEffect } from "preact/hooks";
import { type CurveParts, curved } from "#document/curve/curve";
import { selection } from "#document/morph";
import { Button } from "#ui/Button";
import { help } from "#ui/help";
import { narrow } from "#ui/media";
import type { End } from "./changes";
import { gallery } from "./dialogs";
import { LocusBeside, LocusPanel } from "./locus/LocusPanel";
import { PathPanel } from "./locus/PathPanel";
import { MotionPanel } from "./MotionPanel";
import { MapEditor } from "./maps/MapEditor";
import { PairNotes, PairsPanel } from "./pairs/PairsPanel";
import { ShortcutsDialog } from "./ShortcutsDialog";
import { Ends } from "./shapes/Ends";
import { Gallery } from "./shapes/Gallery";
import { listen } from "./shortcuts";
import { PlaybackOptions } from "./strip/MorphStrip";
import "#ui/panel.css";
import "./morph.css";

export { MorphStrip } from "./strip/MorphStrip";

const choose = (end: End) => {
  gallery.value = end;
};

/** Everything beside the picture: the shapes and the way between both. */
export function MorphPanel({ curve }: { curve: CurveParts }) {
  useEffect(listen, []);
  return (
    <div class="panel morph-panel">
      {curved.value ? <curve.Panel choose={choose} /> : <Systems />}
      {curved.value && narrow.value && <PlaybackOptions />}
      <footer class="panel-foot">
        <Button
          kind="quiet"
          icon="keyboard"
          popup="dialog"
          onClick={() => {
            help.value = true;
          }}
        >
          Keyboard shortcuts
        </Button>
      </footer>
      <Gallery Shelf={curve.Shelf} />
      <ShortcutsDialog />
    </div>
  );
}

/** Two systems, then either the maps of one of them or the way between both. */
function Systems() {
  const editing = selection.value;
  return (
    <>
      <Ends />
      {editing === null ? (
        <Morph />
      ) : (
        <>
          <LocusBeside />
          <MapEditor key={editing.target} target={editing.target} chosen={editing.map} />
        </>
      )}
    </>
  );
}

function Morph() {
  return (
    <>
      <PairNotes />
      <LocusPanel />
      <PathPanel />
      <MotionPanel />
      {narrow.value && <PlaybackOptions />}
      <PairsPanel />
    </>
  );
}
