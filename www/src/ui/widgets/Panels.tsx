import { useState } from "preact/hooks";
import type { MapRow } from "#wasm/api";
import { help } from "../commands";
import { Button } from "../controls/Button";
import { ExportDialog } from "../files/ExportDialog";
import { Dialog } from "../overlay/Dialog";
import { Menu } from "../overlay/Menu";
import { ShortcutsDialog } from "../overlay/ShortcutsDialog";
import { Toasts } from "../overlay/Toasts";
import { ChoiceRow } from "../panel/ChoiceRow";
import { Fold } from "../panel/Fold";
import { PanelFoot } from "../panel/PanelFoot";
import { Problem } from "../panel/Problem";
import { KeyTrack } from "../strip/KeyTrack";
import { LONG, State, Widget } from "./Widget";
import css from "./widgets.module.css";

const nothing = () => {};
const COMMANDS = [
  { id: "play", label: "Play and pause", group: "Time", keys: ["Space"] },
  { id: "undo", label: LONG, group: "Document", keys: ["Ctrl+Z", "Shift+←"] },
];
const HALF: MapRow = [0.5, 0, 0, 0.5, 0, 0];
const MAPS = [
  { label: "A", name: "Half", maps: [HALF] },
  { label: "B", name: LONG, maps: [HALF, HALF] },
];
const TOASTS = [
  { id: 1, kind: "info", text: "The link is in the clipboard." },
  { id: 2, kind: "info", text: "Deleted.", action: { label: "Undo", run: nothing } },
  { id: 3, kind: "error", text: `This file cannot be read. ${LONG}.` },
] as const;

export function Panels() {
  const [toasts, show] = useState(false);
  return (
    <>
      <Widget name="Fold">
        <State name="closed, with what it comes to" wide>
          <Fold title="Continuity" now="joined">
            <p>What is in it.</p>
          </Fold>
        </State>
        <State name="open" wide>
          <Fold title="Continuity" open>
            <p>What is in it.</p>
          </Fold>
        </State>
        <State name="long words" wide>
          <Fold title={LONG} now="many more words beside it">
            <p>What is in it.</p>
          </Fold>
        </State>
      </Widget>
      <Widget name="ChoiceRow" state="plain" wide>
        <ChoiceRow
          label="Ends"
          options={[
            { value: "free", label: "Free" },
            { value: "tied", label: "Tied" },
          ]}
          value="free"
          onChange={nothing}
        />
      </Widget>
      <Widget name="PanelFoot" state="with a button" wide>
        <PanelFoot>
          <Button kind="quiet" icon="reset">
            Reset
          </Button>
        </PanelFoot>
      </Widget>
      <Widget name="Problem" state="long words" wide>
        <Problem words={`${LONG}.`} />
      </Widget>
      <Widget name="Progress" state="a third, and nobody knows how far" wide>
        <progress class="progress" aria-label="A third" value={1} max={3} />
        <progress class="progress" aria-label="Unknown" />
      </Widget>
      <Widget name="Menu" state="press to open">
        <Menu
          label="More"
          items={[
            { label: "Copy", icon: "copy", onSelect: nothing },
            { label: "Not now", icon: "bin", disabled: true, onSelect: nothing },
            { label: LONG, onSelect: nothing },
          ]}
        />
      </Widget>
      <Dialogs />
      <Widget name="Toasts">
        <State name="notice, with an action, error">
          <Button pressed={toasts} onClick={() => show(!toasts)}>
            Notices
          </Button>
        </State>
        {toasts && <Toasts toasts={TOASTS} onDismiss={() => show(false)} />}
      </Widget>
      <Keys />
    </>
  );
}

function Dialogs() {
  const [open, setOpen] = useState<"narrow" | "wide" | "export" | null>(null);
  return (
    <Widget name="Dialog">
      <State name="press to open">
        <div class="row">
          <Button popup="dialog" onClick={() => setOpen("narrow")}>
            Narrow
          </Button>
          <Button popup="dialog" onClick={() => setOpen("wide")}>
            Wide
          </Button>
          <Button popup="dialog" onClick={() => setOpen("export")}>
            Export
          </Button>
          <Button
            popup="dialog"
            onClick={() => {
              help.value = true;
            }}
          >
            Keys
          </Button>
        </div>
      </State>
      {open === "export" && <ExportDialog maps={() => MAPS} onClose={() => setOpen(null)} />}
      {open && open !== "export" && (
        <Dialog title="A dialog" about={LONG} wide={open === "wide"} onClose={() => setOpen(null)}>
          <p>{`${LONG}. `.repeat(open === "wide" ? 60 : 3)}</p>
        </Dialog>
      )}
      <ShortcutsDialog commands={() => COMMANDS} />
    </Widget>
  );
}

function Keys() {
  const [here, go] = useState(1);
  const keys = [{ at: 0 }, { at: 0.4 }, { at: 1 }];
  return (
    <Widget name="KeyTrack" state="three keys, one of them here" wide>
      <div class={css["track"]}>
        <KeyTrack
          label="Keys"
          keys={keys}
          length={1}
          here={here}
          reach={here}
          step={0.1}
          about={(index) => ({ "aria-label": `Key ${index + 1}` })}
          go={go}
          move={nothing}
          remove={nothing}
          Picture={({ index }) => <span>{index + 1}</span>}
        />
      </div>
    </Widget>
  );
}
