import fieldCss from "../kit/frame/field.module.css";
import css from "./find.module.css";

interface FindProps {
  label: string;
  /** What could be looked for. */
  example: string;
  value: string;
  onChange: (words: string) => void;
}

/** Where one writes what one looks for. */
export function Find({ label, example, value, onChange }: FindProps) {
  return (
    <label class={`${fieldCss["field"]} ${css["find"]}`}>
      {label}
      <input
        type="search"
        maxLength={60}
        placeholder={example}
        value={value}
        onInput={({ currentTarget }) => onChange(currentTarget.value)}
      />
    </label>
  );
}
