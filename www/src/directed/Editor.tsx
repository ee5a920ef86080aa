import { useState } from "preact/hooks";
import { dark } from "#document/preferences";
import { fixed } from "#format/numbers";
import { palette } from "#style/palette";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { Select } from "#ui/controls/Select";
import { useOwnId } from "#ui/id";
import { Problem } from "#ui/panel/Problem";
import { MapList } from "#ui/shapes/MapList";
import type { DirectedIfs, MapRow } from "#wasm/api";
import css from "./editor.module.css";
import * as messages from "./messages";
import { doubled, extended, MOST, replaced, shortened, without } from "./systems";

interface EditorProps {
  /** What is edited, as a heading; none where what holds it says so. */
  title: string | null;
  system: DirectedIfs;
  /** What is wrong with it, in words. */
  problem: string | null;
  /** `field` names a number that was changed, so that a run of steps is one undo. */
  onChange: (system: DirectedIfs, field?: string) => void;
  /** The run is over. */
  onDone?: () => void;
}

const NAMES = ["a", "b", "c", "d", "e", "f"] as const;

/** The states, arrows and maps of a graph-directed system. */
export function Editor({ title, system, problem, onChange, onDone }: EditorProps) {
  const heading = useOwnId("editor");
  const [wanted, setState] = useState(0);
  const [open, setOpen] = useState<number | null>(null);
  const colours = palette(dark.value ? "dark" : "light");
  const { states } = system;
  const state = Math.min(wanted, states.length - 1);
  const maps = states[state] ?? [];
  const choose = (next: number) => {
    setState(next);
    setOpen(null);
  };
  return (
    <section
      class={css["editor"]}
      {...(title === null ? { "aria-label": messages.states } : { "aria-labelledby": heading })}
    >
      {title !== null && (
        <header class="section-head">
          <h2 id={heading}>{title}</h2>
        </header>
      )}
      <Problem words={problem} />
      <StateChoice label={messages.state} count={states.length} value={state} onChange={choose} />
      <MapList
        maps={maps.map(({ from, map }) => messages.mapsOfState(from + 1, fixed(map[4]), fixed(map[5])))}
        open={open}
        onOpen={setOpen}
        swatch={(index) => (
          <span
            class={css["swatch"]}
            style={{ background: colours[index % colours.length] }}
            aria-hidden="true"
          />
        )}
        fields={(index) => {
          const part = maps[index];
          if (!part) return null;
          const change = (map: typeof part, field?: string) =>
            onChange(replaced(system, state, index, map), field);
          return (
            <div class={css["fields"]}>
              <StateChoice
                label={messages.copiesState}
                count={states.length}
                value={part.from}
                onChange={(from) => change({ ...part, from })}
              />
              {NAMES.map((name, k) => (
                <NumberField
                  key={name}
                  label={messages.mapNamed(index + 1, name)}
                  symbol={name}
                  terse
                  value={part.map[k] ?? 0}
                  {...(onDone ? { onDone } : {})}
                  onChange={(value) =>
                    change(
                      { ...part, map: part.map.map((old, i) => (i === k ? value : old)) as MapRow },
                      `state-${state}-${index}-${name}`,
                    )
                  }
                />
              ))}
              <Button
                icon="copy"
                kind="quiet"
                disabled={maps.length >= MOST}
                onClick={() => {
                  onChange(doubled(system, state, index));
                  setOpen(maps.length);
                }}
              >
                {messages.duplicate}
              </Button>
              <Button
                icon="bin"
                kind="quiet"
                disabled={maps.length < 2}
                onClick={() => {
                  onChange(without(system, state, index));
                  setOpen(null);
                }}
              >
                {messages.remove}
              </Button>
            </div>
          );
        }}
      />
      <div class={css["buttons"]}>
        <Button
          disabled={states.length >= MOST}
          onClick={() => {
            onChange(extended(system));
            choose(states.length);
          }}
        >
          {messages.addState}
        </Button>
        <Button
          disabled={states.length < 2}
          onClick={() => {
            onChange(shortened(system));
            choose(Math.max(0, states.length - 2));
          }}
        >
          {messages.removeLastState}
        </Button>
      </div>
    </section>
  );
}

interface StateChoiceProps {
  label: string;
  count: number;
  value: number;
  onChange: (state: number) => void;
}

/** One of the states, by its number. */
function StateChoice({ label, count, value, onChange }: StateChoiceProps) {
  return (
    <label class={css["from"]}>
      {label}
      <Select value={String(value)} onChange={(event) => onChange(Number(event.currentTarget.value))}>
        {Array.from({ length: count }, (_, i) => (
          <option key={i} value={String(i)}>
            {i + 1}
          </option>
        ))}
      </Select>
    </label>
  );
}
