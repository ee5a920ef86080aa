import "#style/locus.css";
import "#stage/locus/locus.css";
import "./field.css";
import "#ui/panel/fold.css";
import { computed, signal } from "@preact/signals";
import { useEffect, useState } from "preact/hooks";
import { uv } from "#document/morph";
import { fixed } from "#format/numbers";
import { provedPart, STATE } from "#geometry/states";
import { Legend } from "#stage/locus/Legend";
import { LocusHead, statesIn } from "#stage/locus/LocusHead";
import locusCss from "#stage/locus/locus.module.css";
import type { LocusStyle } from "#stage/locus/paint";
import { Button, IconButton } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { Segmented } from "#ui/controls/Segmented";
import { Slider } from "#ui/controls/Slider";
import { Menu, type MenuItem } from "#ui/overlay/Menu";
import { mode } from "../document-signals";
import { Causes, FamilyNotes, TickOrigins } from "../later";
import { followCritical } from "./families/critical";
import fieldCss from "./field.module.css";
import { LocusSquare } from "./LocusSquare";
import largeCss from "./large.module.css";
import * as messages from "./messages";
import { THICKNESS } from "./path/handles";
import { Now } from "./pointer/Now";
import type { LocusFile } from "./save/save";
import { large, toggleLarge, useLarge } from "./view/large";
import { Ticks } from "./view/Ticks";
import { epsilon, family, offSlice, picked, setPlane, setView, shownField, sides, view } from "./view/view";
import { WindowNumbers } from "./view/WindowNumbers";

type Plane = "morph" | "m" | "polygon";

let lastSides = 3;

/** What is mapped: the morph, or a family whose map is a shape of its own. */
function Planes() {
  const plane: Plane = family.value === "morph" ? "morph" : sides.value === 2 ? "m" : "polygon";
  return (
    <div class="planes">
      <Segmented<Plane>
        label={messages.familyShapes}
        value={plane}
        options={[
          { value: "morph", label: messages.thisMorph, description: messages.allCanLieBetween },
          {
            value: "m",
            label: messages.pairsM,
            description: messages.shapesTwoCopiesRotated,
          },
          {
            value: "polygon",
            label: messages.polygons,
            description: messages.copiesAtCornersPolygon,
          },
        ]}
        onChange={(next) => {
          if (next === "morph") setPlane("morph", 2);
          else setPlane("polygon", next === "m" ? 2 : lastSides);
        }}
      />
      {plane === "polygon" && (
        <NumberField
          label={messages.corners}
          symbol="n"
          value={sides.value}
          min={3}
          max={64}
          whole
          onChange={(next) => {
            if (!Number.isInteger(next)) return messages.enterWholeNumber;
            lastSides = next;
            setPlane("polygon", next);
            return undefined;
          }}
        />
      )}
    </div>
  );
}

const toSlice = (w: number) => setView({ w: Math.abs(w) < 0.004 ? 0 : Math.round(w * 1000) / 1000 });

/** The third parameter: which slice of all morphs the square shows. */
function Slice() {
  const { w } = view.value;
  const [open, setOpen] = useState(w !== 0);
  if (mode.value !== "polar") return null;
  const off = offSlice.value;
  const [, , there = 0] = picked.value ?? uv.value;
  return (
    <details class="fold" open={open || w !== 0} onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>
        {messages.thirdParameter} <span class="dim">{messages.leadsBy(fixed(w, 2))}</span>
      </summary>
      <div class={fieldCss["slice"]}>
        <Slider
          label={messages.wLabel}
          value={w}
          min={-1}
          max={1}
          step={0.01}
          valueText={w === 0 ? messages.wTogether : fixed(w, 2)}
          onChange={toSlice}
        >
          <span class={fieldCss["slice-zero"]} />
        </Slider>
        <NumberField
          terse
          label={messages.wField}
          symbol="w"
          value={w}
          min={-1}
          max={1}
          digits={3}
          onChange={(next) => toSlice(next)}
        />
      </div>
      <p class="hint">{messages.stretchNeedNot}</p>
      {Math.abs(off) > THICKNESS && (
        <p class={fieldCss["slice-off"]}>
          {messages.pictureElsewhere(fixed(there, 2))}{" "}
          <Button onClick={() => toSlice(there)}>{messages.showLocusThere}</Button>
        </p>
      )}
    </details>
  );
}

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
