/** The morph tool: its side panel and its time strip. */
import { useEffect } from "preact/hooks";
import { help } from "../../state/help";
import { selection } from "../../state/morph";
import { Button } from "../../ui/Button";
import { narrow } from "../../ui/media";
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
import "../../ui/panel.css";
import "./morph.css";

export { MorphStrip } from "./strip/MorphStrip";

/** Everything beside the picture: the shapes, then either the maps of one of them or the way between both. */
export function MorphPanel() {
  useEffect(listen, []);
  const editing = selection.value;
  return (
    <div class="panel morph-panel">
      <Ends />
      {editing === null ? (
        <Morph />
      ) : (
        <>
          <LocusBeside />
          <MapEditor key={editing.target} target={editing.target} chosen={editing.map} />
        </>
      )}
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
      <Gallery />
      <ShortcutsDialog />
    </div>
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
