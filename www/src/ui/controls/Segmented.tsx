import "./choice.css";
import type { ComponentChildren } from "preact";
import { withKey } from "../commands";
import { useOwnId } from "../id";

export interface Option<T extends string> {
  value: T;
  label: ComponentChildren;
  /** Shown when pointed at. */
  description?: string;
  disabled?: boolean;
}

export interface SegmentedProps<T extends string> {
  /** What is chosen here, in words; not shown. */
  label: string;
  options: readonly Option<T>[];
  value: T;
  /** The command that chooses the next one, whose key is told with the descriptions. */
  command?: string;
  onChange: (value: T) => void;
}

/** One of a few: a radio group that looks like one divided button. Native radios give it its keys. */
export function Segmented<T extends string>({ label, options, value, command, onChange }: SegmentedProps<T>) {
  const name = useOwnId("choice");
  return (
    <div class="segmented" role="radiogroup" aria-label={label}>
      {options.map((option) => (
        <label
          key={option.value}
          class="segment"
          title={option.description && withKey(option.description, command)}
        >
          <input
            type="radio"
            name={name}
            value={option.value}
            checked={option.value === value}
            disabled={option.disabled ?? false}
            onChange={() => onChange(option.value)}
          />
          <span>{option.label}</span>
        </label>
      ))}
    </div>
  );
}
