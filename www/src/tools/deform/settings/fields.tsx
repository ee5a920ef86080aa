import { computed } from "@preact/signals";
import { changeDeformation, deformation, heldPlain } from "#document/deform/bend";
import { HoldButton } from "#ui/controls/HoldButton";
import { SliderField, type SliderFieldProps } from "#ui/controls/SliderField";
import { useOwnId } from "#ui/id";
import { Fold } from "#ui/panel/Fold";
import deformCss from "../deform.module.css";
import { detailWords, HOLDS, holdWords, localityWords, SPINS } from "../deform-text";
import { facts } from "../facts";
import * as messages from "../messages";

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

interface ChoicesProps<T extends string> {
  label: string;
  options: readonly { value: T; label: string; about: string }[];
  value: T;
  onChange: (value: T) => void;
}

/** One of a few that each need a sentence. */
function Choices<T extends string>({ label, options, value, onChange }: ChoicesProps<T>) {
  const name = useOwnId("choices");
  return (
    <div class={deformCss["bend-choices"]} role="radiogroup" aria-label={label}>
      {options.map((option) => (
        <label key={option.value} class={deformCss["bend-choice"]}>
          <input
            type="radio"
            name={name}
            value={option.value}
            checked={option.value === value}
            onChange={() => onChange(option.value)}
          />
          <span class={deformCss["choice-name"]}>{option.label}</span>
          <span class={deformCss["bend-choice-about"]}>{option.about}</span>
        </label>
      ))}
    </div>
  );
}

type FieldProps = Pick<SliderFieldProps, "label" | "value" | "ends" | "onChange" | "onDone">;

/** How far a shuffle reaches: from everywhere, 0, to nowhere, `ke`. */
export function LocalityField({ ke, ...props }: FieldProps & { ke: number }) {
  return <SliderField {...props} symbol="kb" max={ke} step={0.1} words={localityWords(props.value, ke)} />;
}

/** Down to which scale parts answer. */
export function DetailField({ deepest, ...props }: FieldProps & { deepest: number }) {
  return <SliderField {...props} symbol="ke" max={deepest} step={0.1} words={detailWords(props.value)} />;
}

/** While it is held, the bend is the plain one: nothing is shuffled. */
export function PlainButton() {
  return (
    <HoldButton held={heldPlain} title={messages.holdToSeePlain}>
      {messages.holdForPlain}
    </HoldButton>
  );
}
