import css from "./name-input.module.css";

interface NameInputProps {
  /** What it is the name of, for those who hear it. */
  label: string;
  name: string;
  longest: number;
  /** Another name, which is not empty. */
  onName: (name: string) => void;
  /** The hand leaves it, with a name or without. */
  onEnd?: () => void;
  /** It takes the place of the button that was pressed. */
  focused?: boolean;
}

/** A name that is typed: Enter or leaving takes it, Escape leaves it as it was. */
export function NameInput({ label, name, longest, onName, onEnd, focused = false }: NameInputProps) {
  return (
    <input
      class={css["name"]}
      aria-label={label}
      maxLength={longest}
      spellcheck={false}
      autocomplete="off"
      // biome-ignore lint/a11y/noAutofocus: only where it takes the place of the button that was pressed.
      autoFocus={focused}
      defaultValue={name}
      key={name}
      onKeyDown={(event) => {
        event.stopPropagation();
        if (event.key === "Enter") event.currentTarget.blur();
        if (event.key === "Escape") {
          event.preventDefault();
          event.currentTarget.value = name;
          event.currentTarget.blur();
        }
      }}
      onBlur={(event) => {
        const given = event.currentTarget.value.trim();
        if (given === "") event.currentTarget.value = name;
        onEnd?.();
        if (given !== "" && given !== name) onName(given);
      }}
    />
  );
}
