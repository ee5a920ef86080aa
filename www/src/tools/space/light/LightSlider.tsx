import { endGesture } from "#document/scene";
import { NumberField } from "#ui/NumberField";
import { Slider } from "#ui/Slider";

interface LightSliderProps {
  label: string;
  value: number;
  min?: number;
  max?: number;
  step?: number;
  unit?: string;
  /** The value in words, for those who hear it. */
  words: string;
  /** What lies at the ends, and evenly between them. */
  ends?: readonly string[];
  onChange: (value: number) => void;
}

/** A number by hand and as a number: the same thing twice, one undo step a drag. */
export function LightSlider(props: LightSliderProps) {
  const { label, value, min = 0, max = 1, step = 0.01, unit, words, ends, onChange } = props;
  const digits = step < 1 ? 2 : 0;
  return (
    <div class="light-slider">
      <NumberField
        label={label}
        value={value}
        min={min}
        max={max}
        step={step}
        digits={digits}
        {...(unit === undefined ? {} : { unit })}
        onChange={onChange}
        onDone={endGesture}
      />
      <Slider
        label={label}
        value={value}
        min={min}
        max={max}
        step={step}
        valueText={words}
        // As fine as anyone can point, and short in a link.
        onChange={(next) => onChange(Number(next.toFixed(digits)))}
        onDone={endGesture}
      />
      {ends && (
        <p class="light-ends" aria-hidden="true">
          {ends.map((end, i) => (
            <span key={i}>{end}</span>
          ))}
        </p>
      )}
    </div>
  );
}
