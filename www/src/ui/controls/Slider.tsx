import "./slider.css";
import type { ComponentChildren } from "preact";
import { addStep, keyStep } from "#format/numbers";

export interface SliderProps {
  label: string;
  value: number;
  min?: number;
  max?: number;
  /** What one arrow key moves; shift moves a tenth of it, alt and the page keys ten times. */
  step?: number;
  /** The value in words, for those who hear it. */
  valueText?: string;
  onChange: (value: number) => void;
  onDone?: () => void;
  /** Marks drawn under the thumb, in a box that runs from the lowest to the highest value. */
  children?: ComponentChildren;
  class?: string | undefined;
}

/** A native range input: dragging, touch and reading aloud come with it; the steps of keys are ours. */
export function Slider(props: SliderProps) {
  const { label, value, min = 0, max = 1, step = 0.01 } = props;
  const fill = max > min ? (value - min) / (max - min) : 0;
  return (
    <div class={`slider ${props.class ?? ""}`} style={{ "--fill": String(fill) }}>
      <div class="slider-track" aria-hidden="true">
        {props.children}
        <span class="slider-fill" />
      </div>
      <input
        type="range"
        aria-label={label}
        aria-valuetext={props.valueText}
        min={min}
        max={max}
        step="any"
        value={value}
        onInput={(event) => props.onChange(event.currentTarget.valueAsNumber)}
        onChange={() => props.onDone?.()}
        onBlur={() => props.onDone?.()}
        onKeyDown={(event) => {
          if (event.ctrlKey || event.metaKey) return;
          const by = keyStep(event, step);
          const next =
            event.key === "Home" ? min : event.key === "End" ? max : by === null ? null : addStep(value, by);
          if (next === null) return;
          event.preventDefault();
          props.onChange(Math.min(max, Math.max(min, next)));
        }}
      />
    </div>
  );
}
