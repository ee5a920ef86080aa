import { Segmented, type SegmentedProps } from "../controls/Segmented";

/** One of a few, with its label before it; `name` where those who hear it need more than that. */
export function ChoiceRow<T extends string>({ name, ...props }: SegmentedProps<T> & { name?: string }) {
  return (
    <div class="row">
      <span class="row-name" aria-hidden="true">
        {props.label}
      </span>
      <Segmented {...props} label={name ?? props.label} />
    </div>
  );
}
