import type { ComponentChildren } from "preact";
import { NumberField } from "#ui/controls/NumberField";
import { Select } from "#ui/controls/Select";
import css from "./film.module.css";
import * as messages from "./messages";
import { LEAST_SIDE } from "./plan";

/** A size that has a name. */
export interface NamedSize {
  id: string;
  name: string;
  width: number;
  height: number;
}

interface SizeFieldsProps {
  width: number;
  height: number;
  sizes: readonly NamedSize[];
  /** What stands for no size at all, where that is chosen. */
  first?: { name: string; chosen: boolean; choose: () => void };
  most: number;
  step: number;
  choose: (change: { width?: number; height?: number }) => void;
  /** More numbers beside the two. */
  children?: ComponentChildren;
}

/** How large: by name, or in numbers. */
export function SizeFields({ width, height, sizes, first, most, step, choose, children }: SizeFieldsProps) {
  const named = sizes.find((one) => one.width === width && one.height === height);
  const value = first?.chosen ? "first" : (named?.id ?? "own");
  return (
    <>
      <label class={css["export-size"]}>
        <span class="field-label">{messages.size}</span>
        <Select
          value={value}
          onChange={(event) => {
            const next = sizes.find((one) => one.id === event.currentTarget.value);
            if (next) choose({ width: next.width, height: next.height });
            else if (event.currentTarget.value === "first") first?.choose();
          }}
        >
          {first && <option value="first">{first.name}</option>}
          {sizes.map(({ id, name }) => (
            <option key={id} value={id}>
              {name}
            </option>
          ))}
          {value === "own" && <option value="own">{messages.custom}</option>}
        </Select>
      </label>
      <div class={css["export-pair"]}>
        {(["width", "height"] as const).map((side) => (
          <NumberField
            key={side}
            label={side === "width" ? messages.width : messages.height}
            value={side === "width" ? width : height}
            min={LEAST_SIDE}
            max={most}
            step={step}
            digits={0}
            onChange={(next) => choose({ [side]: next })}
          />
        ))}
        {children}
      </div>
    </>
  );
}
