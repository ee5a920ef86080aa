import { SliderControl } from "../../kit/frame/control";
import { MOST } from "./hill";

/** How tall the copies are. */
export function Copies({ value, onChange }: { value: number; onChange: (s: number) => void }) {
  return (
    <SliderControl
      label="height of the copies"
      symbol="s"
      range={[0, MOST]}
      step={0.01}
      value={value}
      onChange={(next) => onChange(Number(next.toFixed(2)))}
    />
  );
}
