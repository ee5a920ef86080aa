import { useState } from "preact/hooks";
import { Button } from "../controls/Button";
import { NumberField } from "../controls/NumberField";
import * as messages from "../messages";
import css from "./orbit.module.css";

interface MapButtonsProps {
  /** What a press does, before the number: "Apply map". */
  verb: string;
  count: number;
  colours: readonly string[];
  disabled?: boolean;
  onMap: (letter: number) => void;
}

/** There is a key for so many, and room. */
const MOST_BUTTONS = 9;

/** A button for each map, with its number and its colour; of many maps one is named by its number. */
export function MapButtons({ verb, count, colours, disabled = false, onMap }: MapButtonsProps) {
  const [named, setNamed] = useState(1);
  if (count > MOST_BUTTONS)
    return (
      <div class={css["orbit-row"]}>
        <NumberField
          label={messages.map}
          value={Math.min(named, count)}
          whole
          min={1}
          max={count}
          onChange={setNamed}
        />
        <Button disabled={disabled} onClick={() => onMap(Math.min(named, count) - 1)}>
          {verb} {Math.min(named, count)}
        </Button>
      </div>
    );
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset has a look of its own
    <div class={css["orbit-maps"]} role="group" aria-label={verb}>
      {Array.from({ length: count }, (_, letter) => (
        <button
          key={letter}
          type="button"
          class={`button ${css["orbit-button"]}`}
          aria-label={`${verb} ${letter + 1}`}
          title={messages.verbMap(verb, letter + 1, letter + 1)}
          // Not `disabled`: that would take the focus from whoever has pressed it, and the keys with it.
          aria-disabled={disabled}
          style={{ "--map-colour": colours[letter % Math.max(1, colours.length)] }}
          onClick={() => !disabled && onMap(letter)}
        >
          {letter + 1}
        </button>
      ))}
    </div>
  );
}
