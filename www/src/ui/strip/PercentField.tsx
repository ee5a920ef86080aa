import { NumberField, type NumberFieldProps } from "../controls/NumberField";

interface PercentFieldProps extends Pick<NumberFieldProps, "onDone"> {
  label: string;
  /** From 0 to 1. */
  value: number;
  onChange: (value: number) => void;
}

/** A part of the whole, typed in percent. */
export function PercentField({ value, onChange, ...props }: PercentFieldProps) {
  return (
    <NumberField
      terse
      {...props}
      value={100 * value}
      min={0}
      max={100}
      step={1}
      digits={1}
      unit="%"
      onChange={(percentage) => onChange(percentage / 100)}
    />
  );
}
