import { endGesture } from "#document/scene";
import { useOwnId } from "../id";
import css from "./colour-field.module.css";

interface ColourFieldProps {
  label: string;
  /** "#rrggbb" */
  value: string;
  /** While it is chosen: a run of changes is one step to undo. */
  onChange: (value: string) => void;
}

/** A colour, by the system's own way to choose one, with its number. */
export function ColourField({ label, value, onChange }: ColourFieldProps) {
  const id = useOwnId("colour");
  return (
    <div class={css["colour-field"]}>
      <input
        id={id}
        type="color"
        value={value}
        onInput={(event) => onChange(event.currentTarget.value)}
        onChange={endGesture}
        onBlur={endGesture}
      />
      <label for={id}>{label}</label>
      <span class="number">{value}</span>
    </div>
  );
}
