import type { ComponentChildren } from "preact";
import { NumberField } from "#ui/NumberField";
import { Slider } from "#ui/Slider";

interface SliderFieldProps {
  label: string;
  value: number;
  min: number;
  max: number;
  step: number;
  digits?: number;
  unit?: string;
  /** The value in words, for those who hear it. */
  words: string;
  ends?: readonly [string, string];
  onChange: (value: number) => void;
  onDone?: () => void;
  children?: ComponentChildren;
}

/** A number by hand and as a number: the same thing twice. */
export function SliderField(props: SliderFieldProps) {
  const { label, value, min, max, step, digits = 2, unit, words, ends, onChange } = props;
  const done = () => props.onDone?.();
  return (
    <div class="fit-slider">
      <NumberField
        label={label}
        value={value}
        min={min}
        max={max}
        step={step}
        digits={digits}
        {...(unit === undefined ? {} : { unit })}
        onChange={onChange}
        onDone={done}
      />
      <Slider
        label={label}
        value={value}
        min={min}
        max={max}
        step={step}
        valueText={words}
        onChange={(next) => onChange(Number(next.toFixed(digits)))}
        onDone={done}
      >
        {props.children}
      </Slider>
      {ends && (
        <p class="fit-ends" aria-hidden="true">
          <span>{ends[0]}</span>
          <span>{ends[1]}</span>
        </p>
      )}
    </div>
  );
}
