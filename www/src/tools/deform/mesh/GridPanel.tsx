import { computed } from "@preact/signals";
import { changeDeformation } from "#document/deform/bend";
import { endGesture } from "#document/scene";
import { LEAST_SIDE, MOST_SIDE, remesh } from "#geometry/mesh";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import type { Option } from "#ui/controls/Segmented";
import { Switch } from "#ui/controls/Switch";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import { mesh } from "./document";
import { resetAll } from "./edit";
import { HandleFields } from "./handles/HandleFields";
import css from "./mesh.module.css";
import { gridShown } from "./shown";
import { type Symmetry, symmetry } from "./symmetry";

const SYMMETRIES: readonly Option<Symmetry>[] = [
  { value: "off", label: "Off", description: "Each handle moves alone" },
  { value: "sides", label: "Left, right", description: "The mirrored handle on the other side moves too" },
  { value: "levels", label: "Up, down", description: "The mirrored handle above or below moves too" },
  { value: "point", label: "Point", description: "The handle across the middle moves the opposite way" },
];

const rests = computed(() => mesh.value.moves.every((x) => x === 0));

/** The grid itself: what is chosen in numbers, how the hand edits, how many handles there are. */
export function GridPanel() {
  return (
    <section class={`${css["grid-panel"]} stack`} aria-label="Grid">
      <div class="section-head">
        <h2>Grid</h2>
        <Switch
          checked={gridShown.value}
          onChange={(on) => {
            gridShown.value = on;
          }}
        >
          Show it
        </Switch>
      </div>
      <HandleFields />
      <ChoiceRow
        label="Mirror"
        name="Mirror what is moved"
        options={SYMMETRIES}
        value={symmetry.value}
        onChange={(next) => {
          symmetry.value = next;
        }}
      />
      <div class="row">
        <Side of="columns" />
        <Side of="rows" />
        <Button kind="quiet" disabled={rests.value} onClick={resetAll}>
          All back
        </Button>
      </div>
    </section>
  );
}

/** How many handles there are one way: the bend stays as near to what it was as that many allow. */
function Side({ of }: { of: "columns" | "rows" }) {
  return (
    <NumberField
      label={of === "columns" ? "Columns" : "Rows"}
      value={mesh.value[of]}
      min={LEAST_SIDE}
      max={MOST_SIDE}
      step={1}
      digits={2}
      onChange={(next) => {
        if (!Number.isInteger(next)) return "A whole number, please.";
        changeDeformation(
          (d) => remesh(d, of === "columns" ? next : d.columns, of === "rows" ? next : d.rows),
          { gesture: `mesh ${of}` },
        );
        return;
      }}
      onDone={endGesture}
    />
  );
}
