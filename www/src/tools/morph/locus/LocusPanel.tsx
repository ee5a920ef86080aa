import { LocusHead, statesIn } from "#stage/locus/LocusHead";
import "#style/locus.css";
import "#stage/locus/locus.css";
import locusCss from "#stage/locus/locus.module.css";
import "./field.css";
import { computed, signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { provedPart, STATE } from "#geometry/states";
import { Legend } from "#stage/locus/Legend";
import type { LocusStyle } from "#stage/locus/paint";
import { IconButton } from "#ui/controls/Button";
import { Menu, type MenuItem } from "#ui/overlay/Menu";
import { Causes, FamilyNotes, TickOrigins } from "../later";
import { followCritical } from "./families/critical";
import fieldCss from "./field.module.css";
import { LocusSquare } from "./LocusSquare";
import largeCss from "./large.module.css";
import * as messages from "./messages";
import { Now } from "./pointer/Now";
import type { LocusFile } from "./save/save";
import { large, toggleLarge, useLarge } from "./view/large";
import { Planes } from "./view/Planes";
import { Slice } from "./view/Slice";
import { shownField } from "./view/shown";
import { Ticks } from "./view/Ticks";
import { epsilon, family, view } from "./view/view";
import { WindowNumbers } from "./view/WindowNumbers";

/** How the field is shown: a way of looking, no part of the document. */
const style = signal<LocusStyle>("gap");

const zoom = computed(() => view.value.zoom);
const states = statesIn(shownField);
const proved = computed(() => provedPart(shownField.value?.state ?? []));

const save = (kind: LocusFile) => () => {
  void import("./save/save").then(({ saveLocus }) => saveLocus(kind, style.peek()));
};
const SAVES: readonly MenuItem[] = [
  { label: messages.pictureWithAxesPng, onSelect: save("png") },
  { label: messages.drawingWithAxesSvg, onSelect: save("svg") },
  { label: messages.tableCsv, onSelect: save("csv") },
  { label: messages.arrayForNumpyNpy, onSelect: save("npy") },
];
const SAVE_PATH: MenuItem = { label: messages.pathAloneSvg, onSelect: save("path") };

/** The map alone, to be watched while a shape is changed. */
export function LocusBeside() {
  return (
    <section class={`locus ${fieldCss["beside"]}`} aria-labelledby="beside-title">
      <h2 id="beside-title" class={fieldCss["beside-title"]}>
        {messages.whereMorphStaysIn}
      </h2>
      <Plot />
    </section>
  );
}

/** Where the morph holds together: the map of its parameters with the path through it, or that of a famous family. */
export function LocusPanel() {
  useEffect(followCritical, []);
  return (
    <section class="locus" aria-labelledby="locus-title">
      <LocusHead id="locus-title" style={style} term={family.value === "morph" && "the locus"} />
      <div class={fieldCss["which"]}>
        <Planes />
        <span class={fieldCss["acts"]}>
          <IconButton
            icon="enlarge"
            label={messages.enlargeLocus}
            command="map-large"
            pressed={large.value}
            onClick={toggleLarge}
          />
          <Menu
            label={messages.saveLocus}
            icon="save"
            items={family.value === "morph" ? [...SAVES, SAVE_PATH] : SAVES}
          />
        </span>
      </div>
      <Plot />
      <Now />
      {family.value === "morph" && states.value.has(STATE.touching) && <Causes />}
      {family.value === "morph" ? <Slice /> : <FamilyNotes />}
      <WindowNumbers />
    </section>
  );
}

function Plot() {
  useLarge();
  return (
    <>
      <div class={`${locusCss["locus-plot"]} ${largeCss["plot"]}`}>
        <Ticks axis="v" />
        <LocusSquare style={style.value} />
        <Ticks axis="u" />
        {(large.value || zoom.value > 50) && <TickOrigins />}
      </div>
      <Legend states={states.value} epsilon={epsilon.value} style={style.value} proved={proved.value} />
    </>
  );
}
