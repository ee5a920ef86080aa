import type { ComponentChildren } from "preact";
import { fixed } from "#format/numbers";
import { Segmented, type SegmentedProps } from "#ui/controls/Segmented";
import { Slider, type SliderProps } from "#ui/controls/Slider";
import { type Notation, spokenOf } from "../notation/tex";
import css from "./control.module.css";
import { Given } from "./formula";
import layout from "./layout.module.css";

interface ControlProps {
  label: string;
  symbol?: Notation | undefined;
  value: string;
  children: ComponentChildren;
}

/** A field with its name and its value above it. The field names itself to those who hear it. */
export function Control({ label, symbol, value, children }: ControlProps) {
  return (
    <div class={css["control"]} data-control="">
      <div class={css["control-head"]} aria-hidden="true">
        <span>
          {label} {symbol !== undefined && <Given as={symbol} />}
        </span>
        <span class="number">{value}</span>
      </div>
      {children}
    </div>
  );
}

interface SliderControlProps
  extends Pick<SliderProps, "label" | "value" | "step" | "valueText" | "onChange" | "children"> {
  symbol?: Notation | undefined;
  /** What those who hear it are told that it is; its label by default. */
  name?: string;
  /** The lowest and the highest value; 0 and 1 by default. */
  range?: readonly [min: number, max: number];
  /** Only whole numbers. */
  whole?: boolean;
  /** The value as it is shown; to two decimals by default. */
  text?: string;
  /** What belongs below it. */
  below?: ComponentChildren;
}

/** A slider with its name and its value above it. */
export function SliderControl(props: SliderControlProps) {
  const { label, symbol, name = capital(label), range: [min, max] = [0, 1], whole = false } = props;
  const { value, text = whole ? String(value) : fixed(value), onChange } = props;
  return (
    <Control label={label} symbol={symbol} value={text}>
      <Slider
        label={name}
        min={min}
        max={max}
        step={props.step ?? (whole ? 1 : 0.01)}
        value={value}
        valueText={props.valueText ?? (symbol === undefined ? text : `${spokenOf(symbol)} = ${text}`)}
        onChange={(next) => onChange(whole ? Math.round(next) : next)}
      >
        {props.children}
      </Slider>
      {props.below}
    </Control>
  );
}

const capital = (words: string) => words.charAt(0).toUpperCase() + words.slice(1);

/** Buttons of which one is pressed, with their name before them; `name` where those who hear it need more of one. */
export function Choice<T extends string>({ name, ...props }: SegmentedProps<T> & { name?: string }) {
  return (
    <div class={layout["choice"]}>
      <span class={layout["choice-label"]}>{props.label}</span>
      <Segmented {...props} label={name ?? props.label} />
    </div>
  );
}
