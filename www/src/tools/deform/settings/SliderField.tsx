import type { ComponentChildren } from "preact";
import { endGesture } from "#document/scene";
import { NumberField } from "#ui/NumberField";
import { Slider } from "#ui/Slider";

export interface SliderFieldProps {
  label: string;
  /** Small beside the label. */
  symbol: string;
  value: number;
  min?: number;
  max: number;
  /** The field may take more than the slider reaches. */
  most?: number;
  step?: number;
  /** What the value means, in words. */
  words: string;
  /** What lies at the two ends. */
  ends?: readonly [string, string];
  onChange: (value: number) => void;
  onDone?: () => void;
  /** Marks on the slider. */
  children?: ComponentChildren;
}

/** A number by hand and as a number: the same thing twice, one undo step a drag. */
export function SliderField(props: SliderFieldProps) {
  const { label, symbol, value, min = 0, max, most = max, step = 0.01, words, ends, onChange } = props;
  const done = () => {
    endGesture();
    props.onDone?.();
  };
  return (
    <div class="slider-field">
      <NumberField
        label={label}
        symbol={symbol}
        value={value}
        min={min}
        max={most}
        step={step}
        digits={3}
        onChange={onChange}
        onDone={done}
      />
      <Slider
        label={label}
        value={Math.min(max, value)}
        min={min}
        max={max}
        step={step}
        valueText={words}
        // As fine as anyone can point, and short in a link.
        onChange={(next) => onChange(Number(next.toFixed(3)))}
        onDone={done}
      >
        {props.children}
      </Slider>
      {ends && (
        <p class="slider-ends" aria-hidden="true">
          <span>{ends[0]}</span>
          <span>{ends[1]}</span>
        </p>
      )}
    </div>
  );
}
