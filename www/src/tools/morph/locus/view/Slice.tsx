import "#ui/panel/fold.css";
import { useState } from "preact/hooks";
import { uv } from "#document/morph";
import { fixed } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { Slider } from "#ui/controls/Slider";
import { mode } from "../../parts";
import fieldCss from "../field.module.css";
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
        Stretch ahead of turn <span class="dim">this map: w {fixed(w, 2)}</span>
      </summary>
      <div class={fieldCss["slice"]}>
        <Slider
          label="Stretch ahead of turn, w"
          value={w}
          min={-1}
          max={1}
          step={0.01}
          valueText={w === 0 ? "0: turn and stretch together" : fixed(w, 2)}
          onChange={toSlice}
        >
          <span class={fieldCss["slice-zero"]} />
        </Slider>
        <NumberField
          terse
          label="stretch ahead of turn, w"
          symbol="w"
          value={w}
          min={-1}
          max={1}
          digits={3}
          onChange={(next) => toSlice(next)}
        />
      </div>
      <p class="hint">
        Turning and stretching need not go together. Here the square shows the morphs whose stretch is ahead
        of their turn by <span class="symbol">w</span>.
      </p>
      {Math.abs(off) > THICKNESS && (
        <p class={fieldCss["slice-off"]}>
          The picture is at <span class="symbol">w</span> {fixed(there, 2)}, and not on this map.{" "}
          <Button onClick={() => toSlice(there)}>Show the map there</Button>
        </p>
      )}
    </details>
  );
}
