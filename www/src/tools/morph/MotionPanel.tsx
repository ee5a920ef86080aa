import { edit } from "#document/scene";
import { Palettes } from "#stage/later";
import { Button } from "#ui/controls/Button";
import { Switch } from "#ui/controls/Switch";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import type { Colouring, Mode } from "#wasm/api";
import { FOLLOW, orbitOpen, toggleOrbit } from "./dialogs";
import { colouring, compare, mode } from "./document-signals";
import * as messages from "./messages";
import css from "./morph.module.css";

const MODES: readonly { value: Mode; label: string; description: string }[] = [
  {
    value: "polar",
    label: messages.byRotation,
    description: messages.polarEachMapRotates,
  },
  { value: "linear", label: messages.entryByEntry, description: messages.linearMatrixEntriesBlended },
];

const COLOURINGS: readonly { value: Colouring; label: string; description: string }[] = [
  { value: "map", label: messages.map, description: messages.oneColourForEach },
  { value: "address", label: messages.address, description: messages.shadeForEachCopy },
  { value: "density", label: messages.density, description: messages.brighterWhereMorePoints },
];

/** How it moves from one shape to the other, and how it is coloured. */
export function MotionPanel() {
  return (
    <section class={css["motion"]} aria-label={messages.motionAndColour}>
      <ChoiceRow
        label={messages.blendMaps}
        value={mode.value}
        options={MODES}
        onChange={(next) => edit((before) => ({ ...before, mode: next }))}
      />
      <div class="row">
        <Switch
          checked={compare.value}
          description={messages.showsBothWaysTo}
          onChange={(next) => edit((before) => ({ ...before, compare: next }))}
        >
          {messages.compareBothSideBy}
        </Switch>
      </div>
      <ChoiceRow
        label={messages.colourBy}
        value={colouring.value}
        options={COLOURINGS}
        onChange={(next) => edit((before) => ({ ...before, colouring: next }))}
      />
      <Palettes />
      <div class="row">
        <Button
          description={messages.applyMapsToPoint}
          command="orbit"
          buttonRef={FOLLOW}
          onClick={toggleOrbit}
        >
          {orbitOpen.value ? messages.stopFollowingPoint : messages.followPoint}
        </Button>
      </div>
    </section>
  );
}
