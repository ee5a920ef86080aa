import { endGesture } from "#document/scene";
import { NumberField } from "#ui/NumberField";
import { Slider } from "#ui/Slider";

export interface SliderFieldProps {
  label: string;
  symbol?: string;
  value: number;
  min: number;
  max: number;
  step: number;
  unit?: string;
  digits?: number;
  /** What one arrow key moves the number by, where that is not what it moves the slider by. */
  fieldStep?: number;
  /** Where a slider's way is not that of the numbers: both ways. `min`, `max` and `step` are the slider's then. */
  scale?: { to: (value: number) => number; from: (at: number) => number };
  /** Takes a value, or says in a sentence why it cannot be; then the last good value stays. */
  // biome-ignore lint/suspicious/noConfusingVoidType: a caller that cannot refuse returns nothing
  onChange: (value: number) => string | undefined | void;
}

/** A number by hand and as a number: the same thing twice, one undo step a drag. */
export function SliderField(props: SliderFieldProps) {
  const { label, symbol, value, min, max, step, unit, digits = 3, scale, fieldStep = step, onChange } = props;
  const at = Math.min(max, Math.max(min, scale ? scale.to(value) : value));
  return (
    <div class="solid-slider">
      <NumberField
        label={label}
        {...(symbol === undefined ? {} : { symbol })}
        value={value}
        step={fieldStep}
        digits={digits}
        {...(unit === undefined ? {} : { unit })}
        onChange={onChange}
        onDone={endGesture}
      />
      <Slider
        label={label}
        value={at}
        min={min}
        max={max}
        step={step}
        valueText={`${Number(value.toPrecision(4))}${unit ?? ""}`}
        onChange={(next) => {
          onChange(scale ? scale.from(next) : Number(next.toPrecision(5)));
        }}
        onDone={endGesture}
      />
    </div>
  );
}
