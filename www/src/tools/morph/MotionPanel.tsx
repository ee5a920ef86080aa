import { edit } from "#document/scene";
import { Palettes } from "#stage/later";
import { Button } from "#ui/controls/Button";
import { Switch } from "#ui/controls/Switch";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import type { Colouring, Mode } from "#wasm/api";
import { FOLLOW, orbitOpen, toggleOrbit } from "./dialogs";
import css from "./morph.module.css";
import { colouring, compare, mode } from "./parts";

const MODES: readonly { value: Mode; label: string; description: string }[] = [
  {
    value: "polar",
    label: "Turning",
    description: "Polar: each map turns and stretches on its own, so pieces keep their size",
  },
  { value: "linear", label: "Linear", description: "Number by number: pieces shrink and flatten half-way" },
];

const COLOURINGS: readonly { value: Colouring; label: string; description: string }[] = [
  { value: "map", label: "Map", description: "One colour for each of the largest copies" },
  { value: "address", label: "Address", description: "A shade for each copy of a copy" },
  { value: "density", label: "Density", description: "Brighter where points fall more often" },
];

/** How it moves from one shape to the other, and how it is coloured. */
export function MotionPanel() {
  return (
    <section class={css["motion"]} aria-label="Motion and colour">
      <ChoiceRow
        label="Motion"
        value={mode.value}
        options={MODES}
        onChange={(next) => edit((before) => ({ ...before, mode: next }))}
      />
      <div class="row">
        <Switch
          checked={compare.value}
          description="The turning morph and the linear one at the same moment"
          onChange={(next) => edit((before) => ({ ...before, compare: next }))}
        >
          Turning and linear side by side
        </Switch>
      </div>
      <ChoiceRow
        label="Colour by"
        value={colouring.value}
        options={COLOURINGS}
        onChange={(next) => edit((before) => ({ ...before, colouring: next }))}
      />
      <Palettes />
      <div class="row">
        <Button
          description="Apply the maps to a point one by one, or read its address"
          command="orbit"
          buttonRef={FOLLOW}
          onClick={toggleOrbit}
        >
          {orbitOpen.value ? "End following the point" : "Follow a point"}
        </Button>
      </div>
    </section>
  );
}
