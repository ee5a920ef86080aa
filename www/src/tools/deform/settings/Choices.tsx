import { useOwnId } from "#ui/id";
import deformCss from "../deform.module.css";

export interface ChoicesProps<T extends string> {
  label: string;
  options: readonly { value: T; label: string; about: string }[];
  value: T;
  onChange: (value: T) => void;
}

/** One of a few that each need a sentence. */
export function Choices<T extends string>({ label, options, value, onChange }: ChoicesProps<T>) {
  const name = useOwnId("choices");
  return (
    <div class={deformCss["bend-choices"]} role="radiogroup" aria-label={label}>
      {options.map((option) => (
        <label key={option.value} class={deformCss["bend-choice"]}>
          <input
            type="radio"
            name={name}
            value={option.value}
            checked={option.value === value}
            onChange={() => onChange(option.value)}
          />
          <span class={deformCss["choice-name"]}>{option.label}</span>
          <span class={deformCss["bend-choice-about"]}>{option.about}</span>
        </label>
      ))}
    </div>
  );
}
