/** What the figures of the triangle share: where it is seen from, which maps make it, and what was not printed. */

import { useMemo } from "preact/hooks";
import { turns3 } from "#geometry/maps/affine3";
import type { SpaceView } from "#wasm/api";
import { Choice } from "../../kit/frame/control";
import { oneOf } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { VIEW } from "./eye";
import { type Form, triangle } from "./shapes";
import { inSpaceTool } from "./tool-link";
import { ANGLES, AngleSliders, type Angles, Conjugated, inRadians } from "./turning";

export const TRIANGLE_VIEW: SpaceView = {
  target: [0, 0, 0],
  distance: 2.6,
  turn: 0.35,
  tilt: 0.2,
  angle: 0.5,
};

export const CUT_OFF =
  "The scan of the paper cuts the parameters off: of each map only some numbers can be read. The corners of this triangle are Frond’s own.";

/** Of each map, as it is made. */
export const MATRICES: Readonly<Record<Form, string>> = {
  halves: "diag(0.5, 0.5, 0.5)",
  sheet: "diag(0.5, 0, 0.5)",
};

/** What stands in the addresses of its figures. */
export const stateOf = (form: Form, angles: Angles) => ({
  form: kept(form, oneOf<Form>(["halves", "sheet"])),
  angles: kept(angles, ANGLES),
  view: kept(TRIANGLE_VIEW, VIEW),
});

/** The triangle turned by three angles: what its figures keep, and what follows. */
export function useTurnedTriangle(state: ReturnType<typeof stateOf>) {
  const [form, setForm] = useKept("form", ...state.form);
  const [angles, setAngles] = useKept("angles", ...state.angles);
  const [view, setView] = useKept("view", ...state.view);
  const made = useMemo(() => triangle(form), [form]);
  const by = useMemo(() => turns3(inRadians(angles)), [angles]);
  return { form, setForm, angles, setAngles, view, setView, made, by };
}

type Turned = ReturnType<typeof useTurnedTriangle>;

export const turnedInTool = ({ made, by, view }: Turned) =>
  inSpaceTool([{ name: "Triangle", maps: made, moved: by }], view);

/** Its picture and parameters, with what changes them. */
export function TurnedTriangle({ of, label }: { of: Turned; label: string }) {
  const { form, setForm, angles, setAngles, view, setView, made, by } = of;
  return (
    <>
      <Choice
        label="Maps that"
        name="Which maps make the triangle"
        value={form}
        options={[
          { value: "halves", label: "halve everything" },
          { value: "sheet", label: "also flatten" },
        ]}
        onChange={setForm}
      />
      <Conjugated made={made} by={by} view={view} onView={setView} label={label}>
        <AngleSliders angles={angles} onChange={setAngles} />
      </Conjugated>
    </>
  );
}
