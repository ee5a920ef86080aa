import { SliderField, type SliderFieldProps } from "#ui/controls/SliderField";
import { detailWords, localityWords } from "../words";

type FieldProps = Pick<SliderFieldProps, "label" | "value" | "ends" | "onChange" | "onDone">;

/** How far a shuffle reaches: from everywhere, 0, to nowhere, `ke`. */
export function LocalityField({ ke, ...props }: FieldProps & { ke: number }) {
  return <SliderField {...props} symbol="kb" max={ke} step={0.1} words={localityWords(props.value, ke)} />;
}

/** Down to which scale parts answer. */
export function DetailField({ deepest, ...props }: FieldProps & { deepest: number }) {
  return <SliderField {...props} symbol="ke" max={deepest} step={0.1} words={detailWords(props.value)} />;
}
