import { useState } from "preact/hooks";
import { dark } from "#document/preferences";
import { fixed } from "#format/numbers";
import { palette } from "#style/palette";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { Select } from "#ui/controls/Select";
import { Problem } from "#ui/panel/Problem";
import { MapList } from "#ui/shapes/MapList";
import type { DirectedIfs, MapRow } from "#wasm/api";
import { Choice } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { useValue } from "../../kit/workers";
import css from "./page.module.css";
import { doubled, extended, MOST, replaced, shortened, without } from "./systems";

interface EditorProps {
  system: DirectedIfs;
  /** What is wrong with it, in words. */
  problem: string | null;
  onChange: (system: DirectedIfs) => void;
}

const NAMES = ["a", "b", "c", "d", "e", "f"] as const;

/** The states, arrows and maps of the first shape. */
export function Editor({ system, problem, onChange }: EditorProps) {
  const [wanted, setState] = useState(0);
  const [open, setOpen] = useState<number | null>(null);
  const colours = palette(useValue(dark) ? "dark" : "light");
  const { states } = system;
  const state = Math.min(wanted, states.length - 1);
  const maps = states[state] ?? [];
  const choose = (next: number) => {
    setState(next);
    setOpen(null);
  };
  return (
    <section class={css["editor"]} aria-labelledby="editor">
      <h2 id="editor">The maps of the first shape</h2>
      <Problem words={problem} />
      <Choice
        label="State"
        options={states.map((_, i) => ({ value: String(i), label: String(i + 1) }))}
        value={String(state)}
        onChange={(value) => choose(Number(value))}
      />
      <MapList
        maps={maps.map(
          ({ from, map }) => `a copy of state ${from + 1} at (${fixed(map[4])}, ${fixed(map[5])})`,
        )}
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
          const change = (map: typeof part) => onChange(replaced(system, state, index, map));
          return (
            <div class={css["fields"]}>
              <label class={css["from"]}>
                Copies state
                <Select
                  value={String(part.from)}
                  onChange={(event) => change({ ...part, from: Number(event.currentTarget.value) })}
                >
                  {states.map((_, i) => (
                    <option key={i} value={String(i)}>
                      {i + 1}
                    </option>
                  ))}
                </Select>
              </label>
              {NAMES.map((name, k) => (
                <NumberField
                  key={name}
                  label={`Map ${index + 1}, ${name}`}
                  symbol={name}
                  terse
                  value={part.map[k] ?? 0}
                  onChange={(value) =>
                    change({ ...part, map: part.map.map((old, i) => (i === k ? value : old)) as MapRow })
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
                Duplicate
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
                Remove
              </Button>
            </div>
          );
        }}
      />
      <div class={layout["buttons"]}>
        <Button
          disabled={states.length >= MOST}
          onClick={() => {
            onChange(extended(system));
            choose(states.length);
          }}
        >
          Add a state
        </Button>
        <Button
          disabled={states.length < 2}
          onClick={() => {
            onChange(shortened(system));
            choose(Math.max(0, states.length - 2));
          }}
        >
          Remove the last state
        </Button>
      </div>
    </section>
  );
}
