/** What the figures of the triangle share: where it is seen from, which maps make it, and what was not printed. */

import { Segmented } from "#ui/controls/Segmented";
import type { SpaceView } from "#wasm/api";
import layout from "../../kit/frame/layout.module.css";
import type { Form } from "./shapes";

export const TRIANGLE_VIEW: SpaceView = {
  target: [0, 0, 0],
  distance: 2.6,
  turn: 0.35,
  tilt: 0.2,
  angle: 0.5,
};

export const CUT_OFF =
  "The scan of the paper cuts the parameters off: of each map only some numbers can be read. The corners of this triangle are Frond’s own.";

export function FormChoice({ form, onChange }: { form: Form; onChange: (form: Form) => void }) {
  return (
    <div class={layout["buttons"]}>
      <span class={layout["choice-label"]}>Maps that</span>
      <Segmented
        label="Which maps make the triangle"
        value={form}
        options={[
          { value: "halves", label: "halve everything" },
          { value: "sheet", label: "also flatten" },
        ]}
        onChange={onChange}
      />
    </div>
  );
}
