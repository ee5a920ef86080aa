import { computed } from "@preact/signals";
import { changeDeformation, deformation } from "#document/deform/bend";
import { facts } from "../facts";
import { HOLDS, holdWords, SPINS } from "../words";
import { Choices } from "./Choices";

const spin = computed(() => deformation.value.spin);
const continuity = computed(() => deformation.value.continuity);

/** How displacements turn with the pieces. */
export function SpinFold() {
  const now = SPINS.find(({ value }) => value === spin.value);
  return (
    <details class="bend-fold">
      <summary>
        <span>Turning in the pieces</span>
        <span class="fold-now">{now?.label.toLowerCase()}</span>
      </summary>
      <Choices
        label="Turning in the pieces"
        options={SPINS}
        value={spin.value}
        onChange={(next) => changeDeformation((d) => ({ ...d, spin: next }))}
      />
    </details>
  );
}

/** What keeps neighbouring pieces together. */
export function ContinuityFold() {
  const got = facts.value?.continuity ?? null;
  return (
    <details class="bend-fold">
      <summary>
        <span>Kept together by</span>
        <span class="fold-now">{holdWords(continuity.value, got)}</span>
      </summary>
      <Choices
        label="Kept together by"
        options={HOLDS}
        value={continuity.value}
        onChange={(next) => changeDeformation((d) => ({ ...d, continuity: next }))}
      />
    </details>
  );
}
