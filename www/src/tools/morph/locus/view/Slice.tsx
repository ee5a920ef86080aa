import "#ui/panel/fold.css";
import { useState } from "preact/hooks";
import { uv } from "#document/morph";
import { fixed } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { Slider } from "#ui/controls/Slider";
import { mode } from "../../parts";
import fieldCss from "../field.module.css";
import * as messages from "../messages";
import { THICKNESS } from "../path/handles";
import { offSlice, picked, setView, view } from "./view";

const toSlice = (w: number) => setView({ w: Math.abs(w) < 0.004 ? 0 : Math.round(w * 1000) / 1000 });

/** The third parameter: which slice of all morphs the square shows. */
export function Slice() {
  const { w } = view.value;
  const [open, setOpen] = useState(w !== 0);
  if (mode.value !== "polar") return null;
  const off = offSlice.value;
  const [, , there = 0] = picked.value ?? uv.value;
  return (
    <details class="fold" open={open || w !== 0} onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>
        {messages.thirdParameter} <span class="dim">{messages.leadsBy(fixed(w, 2))}</span>
      </summary>
      <div class={fieldCss["slice"]}>
        <Slider
          label={messages.wLabel}
          value={w}
          min={-1}
          max={1}
          step={0.01}
          valueText={w === 0 ? messages.wTogether : fixed(w, 2)}
          onChange={toSlice}
        >
          <span class={fieldCss["slice-zero"]} />
        </Slider>
        <NumberField
          terse
          label={messages.wField}
          symbol="w"
          value={w}
          min={-1}
          max={1}
          digits={3}
          onChange={(next) => toSlice(next)}
        />
      </div>
      <p class="hint">{messages.stretchNeedNot}</p>
      {Math.abs(off) > THICKNESS && (
        <p class={fieldCss["slice-off"]}>
          {messages.pictureElsewhere(fixed(there, 2))}{" "}
          <Button onClick={() => toSlice(there)}>{messages.showLocusThere}</Button>
        </p>
      )}
    </details>
  );
}
