import { NIGHT, PAPER } from "#style/colours";
import { ownFrom } from "#style/ground";
import { Select } from "#ui/controls/Select";
import css from "./film.module.css";
import * as messages from "./messages";

interface GroundProps {
  of: { ground: string | null; clear: boolean };
  /** What it is on the stage. */
  stage: string;
  canBeClear: boolean;
  choose: (change: { ground?: string | null; clear?: boolean }) => void;
}

/** What is behind the picture. */
export function Ground({ of: { ground, clear }, stage, canBeClear, choose }: GroundProps) {
  const named = ground === null ? "stage" : ground === PAPER ? "paper" : ground === NIGHT ? "night" : "own";
  const value = clear && canBeClear ? "clear" : named;
  return (
    <label class={css["export-size"]}>
      <span class="field-label">{messages.background}</span>
      <Select
        value={value}
        onChange={(event) => {
          const next = event.currentTarget.value;
          const colours: Record<string, string | null> = {
            stage: null,
            paper: PAPER,
            night: NIGHT,
            own: ownFrom(ground ?? stage),
          };
          if (next === "clear") choose({ clear: true });
          else choose({ clear: false, ground: colours[next] ?? null });
        }}
      >
        <option value="stage">{messages.asHere}</option>
        <option value="paper">{messages.paper}</option>
        <option value="night">{messages.night}</option>
        <option value="own">{messages.custom}</option>
        {canBeClear && <option value="clear">{messages.transparent}</option>}
      </Select>
      {value === "own" && (
        <input
          type="color"
          class={css["ground-colour"]}
          aria-label={messages.backgroundColour}
          value={ground ?? stage}
          onInput={(event) => choose({ ground: event.currentTarget.value })}
        />
      )}
    </label>
  );
}
