import { Select } from "#ui/controls/Select";
import css from "./film.module.css";
import * as messages from "./messages";
import type { SeedName } from "./seed";
import { chooseSeed } from "./settings";
import type { Seeds } from "./subject";

/** The figure that a shape in the making begins with. */
export function SeedField({ of }: { of: Seeds }) {
  return (
    <label class={css["export-size"]}>
      <span class="field-label">{messages.startsWith}</span>
      <Select value={of.value} onChange={(event) => chooseSeed(event.currentTarget.value as SeedName)}>
        {of.options.map(({ value, label }) => (
          <option key={value} value={value}>
            {label}
          </option>
        ))}
      </Select>
    </label>
  );
}
