import { NumberField } from "#ui/controls/NumberField";
import { Select } from "#ui/controls/Select";
import type { Point3 } from "#wasm/api";
import { solid } from "#wasm/space";
import { Control } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { type Field, list, number, parts, text } from "../../kit/state/fields";
import { sharesLinear } from "./meets";
import css from "./own-shape.module.css";

/** Two shapes of the gallery, the second in its own place. */
export interface Own {
  first: string;
  second: string;
  scale: number;
  shift: Point3;
}

export const OWN: Own = { first: "sponge", second: "dust", scale: 1, shift: [0, 0, 0] };

const LEAST = 0.01;
const FARTHEST = 100;
/** Of a shape of the gallery; whether there is one of this name is asked where it is shown. */
const ID = text(/[a-z0-9-]{1,32}/);

/** As it stands in an address. */
export const OWN_FIELD: Field<Own> = parts({
  first: ID,
  second: ID,
  scale: number(LEAST, FARTHEST, 6),
  shift: list(number(-FARTHEST, FARTHEST, 6), 3, 3, "_") as Field<Point3>,
});

const AXES = ["x", "y", "z"] as const;

/** Which two shapes, and where the second lies. */
export function OwnShapes({ own, onChange }: { own: Own; onChange: (own: Own) => void }) {
  return (
    <div class={css["meet-own"]}>
      <Choice name="First shape" value={own.first} onChange={(first) => onChange({ ...own, first })} />
      <Choice name="Second shape" value={own.second} onChange={(second) => onChange({ ...own, second })} />
      <fieldset class={css["meet-place"]}>
        <legend class={layout["choice-label"]}>The second, scaled and moved</legend>
        <NumberField
          terse
          label="Scale of the second shape"
          symbol="×"
          value={own.scale}
          min={LEAST}
          max={FARTHEST}
          step={0.1}
          onChange={(scale) => onChange({ ...own, scale })}
        />
        {AXES.map((axis, k) => (
          <NumberField
            key={axis}
            terse
            label={`Second shape moved along ${axis}`}
            symbol={axis}
            value={own.shift[k] ?? 0}
            min={-FARTHEST}
            max={FARTHEST}
            step={0.1}
            onChange={(next) =>
              onChange({ ...own, shift: own.shift.map((x, i) => (i === k ? next : x)) as Point3 })
            }
          />
        ))}
      </fieldset>
    </div>
  );
}

function Choice({ name, value, onChange }: { name: string; value: string; onChange: (id: string) => void }) {
  const all = solid.presets3();
  const groups = [
    { label: "One matrix for all maps", list: all.filter(({ maps }) => sharesLinear(maps)) },
    { label: "Several matrices", list: all.filter(({ maps }) => !sharesLinear(maps)) },
  ];
  const chosen = all.find(({ id }) => id === value);
  return (
    <Control label={name} value={`${chosen?.maps.length ?? 0} maps`}>
      <Select aria-label={name} value={value} onChange={(event) => onChange(event.currentTarget.value)}>
        {groups.map(({ label, list }) => (
          <optgroup key={label} label={label}>
            {list.map((preset) => (
              <option key={preset.id} value={preset.id}>
                {preset.name}
              </option>
            ))}
          </optgroup>
        ))}
      </Select>
    </Control>
  );
}
