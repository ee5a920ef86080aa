import type { ComponentChildren } from "preact";
import { endGesture } from "#document/scene";
import { NumberField, type NumberFieldProps } from "./NumberField";
import { Slider } from "./Slider";
import css from "./slider-field.module.css";

export interface SliderFieldProps extends Pick<NumberFieldProps, "label" | "symbol" | "unit" | "onChange"> {
  value: number;
  /** Of the slider. */
  min?: number;
  max?: number;
  step?: number;
  /** Of the field, where it takes more than the slider reaches, or steps otherwise. */
  field?: { min?: number; max?: number; step?: number };
  digits?: number;
  /** Where a slider's way is not that of the numbers: both ways. `min`, `max` and `step` are the slider's then. */
  scale?: { to: (value: number) => number; from: (at: number) => number };
  /** The value in words, for those who hear it. */
  words?: string;
  /** What lies at the ends, and evenly between them. */
  ends?: readonly string[];
  onDone?: () => void;
  /** Marks on the slider. */
  children?: ComponentChildren;
}

/** A number by hand and as a number: the same thing twice, one undo step a drag. */
export function SliderField(props: SliderFieldProps) {
  const {
    label,
    symbol,
    value,
    min = 0,
    max = 1,
    step = 0.01,
    digits = 3,
    unit,
    scale,
    ends,
    onChange,
  } = props;
  const field = props.field ?? { min, max };
  const done = () => {
    endGesture();
    props.onDone?.();
  };
  return (
    <div class={css["slider-field"]}>
      <NumberField
        label={label}
        value={value}
        step={step}
        digits={digits}
        {...field}
        {...(symbol === undefined ? {} : { symbol })}
        {...(unit === undefined ? {} : { unit })}
        onChange={onChange}
        onDone={done}
      />
      <Slider
        label={label}
        value={Math.min(max, Math.max(min, scale ? scale.to(value) : value))}
        min={min}
        max={max}
        step={step}
        valueText={props.words ?? `${Number(value.toPrecision(4))}${unit ?? ""}`}
        // As fine as anyone can point, and short in a link.
        onChange={(next) => {
          onChange(scale ? scale.from(next) : Number(next.toFixed(digits)));
        }}
        onDone={done}
      >
        {props.children}
      </Slider>
      {ends && (
        <p class={css["slider-ends"]} aria-hidden="true">
          {ends.map((end) => (
            <span key={end}>{end}</span>
          ))}
        </p>
      )}
    </div>
  );
}
