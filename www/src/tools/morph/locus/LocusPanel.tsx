import "#stage/locus/locus.css";
import "./field.css";
import { computed, signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { Legend } from "#stage/locus/Legend";
import type { LocusStyle } from "#stage/locus/paint";
import { Segmented } from "#ui/controls/Segmented";
import { followCritical } from "./families/critical";
import { FamilyNotes } from "./families/FamilyNotes";
import { LocusSquare } from "./LocusSquare";
import { Now } from "./pointer/Now";
import { Planes } from "./view/Planes";
import { Slice } from "./view/Slice";
import { shownField } from "./view/shown";
import { Ticks } from "./view/Ticks";
import { epsilon, family } from "./view/view";
import { WindowNumbers } from "./view/WindowNumbers";

/** How the field is shown: a way of looking, no part of the document. */
const style = signal<LocusStyle>("gap");

/** Which states there are in the window; the same as long as they stay the same. */
const present = computed(() => [...new Set(shownField.value?.state)].sort().join());
const states = computed(() => new Set(present.value.split(",").filter(Boolean).map(Number)));

/** The map alone, to be watched while a shape is changed. */
export function LocusBeside() {
  return (
    <section class="locus beside" aria-labelledby="beside-title">
      <h2 id="beside-title" class="beside-title">
        Where the morph holds together
      </h2>
      <div class="locus-plot">
        <Ticks axis="v" />
        <LocusSquare style={style.value} />
        <Ticks axis="u" />
      </div>
      <Legend states={states.value} epsilon={epsilon.value} style={style.value} />
    </section>
  );
}

/** Where the morph holds together: the map of its parameters with the path through it, or that of a famous family. */
export function LocusPanel() {
  useEffect(followCritical, []);
  return (
    <section class="locus" aria-labelledby="locus-title">
      <header class="section-head">
        <h2 id="locus-title">Where it holds together</h2>
        <Segmented
          label="How to show it"
          value={style.value}
          onChange={(next) => {
            style.value = next;
          }}
          options={[
            { value: "gap", label: "Gap", description: "How wide the widest gap between the pieces is" },
            { value: "yesno", label: "Yes / no", description: "Only whether it holds together" },
          ]}
        />
      </header>
      <Planes />
      <div class="locus-plot">
        <Ticks axis="v" />
        <LocusSquare style={style.value} />
        <Ticks axis="u" />
      </div>
      <Legend states={states.value} epsilon={epsilon.value} style={style.value} />
      <Now />
      {family.value === "morph" ? <Slice /> : <FamilyNotes />}
      <WindowNumbers />
    </section>
  );
}
