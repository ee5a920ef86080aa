import { computed } from "@preact/signals";
import { changeDeformation, deformation } from "#document/deform/bend";
import { Fold } from "#ui/panel/Fold";
import { facts } from "../facts";
import * as messages from "../messages";
import { HOLDS, holdWords, SPINS } from "../words";
import { Choices } from "./Choices";

const spin = computed(() => deformation.value.spin);
const continuity = computed(() => deformation.value.continuity);

/** How displacements turn with the pieces. */
export function SpinFold() {
  const now = SPINS.find(({ value }) => value === spin.value);
  return (
    <Fold title={messages.rotationInPieces} now={now?.label.toLowerCase()}>
      <Choices
        label={messages.rotationInPieces}
        options={SPINS}
        value={spin.value}
        onChange={(next) => changeDeformation((d) => ({ ...d, spin: next }))}
      />
    </Fold>
  );
}

/** What keeps neighbouring pieces together. */
export function ContinuityFold() {
  const got = facts.value?.continuity ?? null;
  return (
    <Fold title={messages.continuity} now={holdWords(continuity.value, got)}>
      <Choices
        label={messages.continuity}
        options={HOLDS}
        value={continuity.value}
        onChange={(next) => changeDeformation((d) => ({ ...d, continuity: next }))}
      />
    </Fold>
  );
}
