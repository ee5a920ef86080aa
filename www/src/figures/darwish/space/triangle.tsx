/** What the figures of the triangle share: where it is seen from, which maps make it, and what was not printed. */

import { useMemo } from "preact/hooks";
import { turns3 } from "#geometry/maps/affine3";
import type { SpaceView } from "#wasm/api";
import { Choice } from "../../kit/frame/control";
import { oneOf } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { VIEW } from "./eye";
import { type Form, TRIANGLE_MIDDLE, triangle } from "./shapes";
import { inSpaceTool } from "./tool-link";
import { ANGLES, AngleSliders, type Angles, Conjugated, inRadians } from "./turning";

/** From above, a little aslant: the triangle lies in the plane of x and y. */
const TRIANGLE_VIEW: SpaceView = {
  target: TRIANGLE_MIDDLE,
  distance: 2.6,
  turn: 0.15,
  tilt: 1.25,
  angle: 0.42,
};

/** Where the first numbers of the triangle's translations come from. */
export const BY_FIGURE_IV =
  "by the sides of the triangle of Figure iv, which is printed whole, and so that Figure ii is a turn of it";
/** The same, on pages of the figures that follow. */
export const THAT_OF_FIGURE_I = `The triangle is that of Figure i, whose first translations are reconstructed: ${BY_FIGURE_IV}.`;

/** Of each map, as it is made. */
export const MATRICES: Readonly<Record<Form, string>> = {
  halves: "diag(0.5, 0.5, 0.5)",
  sheet: "diag(0.5, 0.5, 0)",
};

/** What differs from the paper where the maps are chosen that flatten. */
export const differsBy = (form: Form): string | undefined =>
  form === "sheet"
    ? "The matrices in print are 0.5 I. Those that also flatten are Frond’s addition: they make the same picture."
    : undefined;

/** What stands in the addresses of its figures. */
export const stateOf = (angles: Angles) => ({
  form: kept<Form>("halves", oneOf<Form>(["halves", "sheet"])),
  angles: kept(angles, ANGLES),
  // `view` stood in addresses while the triangle was another one, and lay elsewhere.
  seen: kept(TRIANGLE_VIEW, VIEW),
});

/** The triangle turned by three angles: what its figures keep, and what follows. */
export function useTurnedTriangle(state: ReturnType<typeof stateOf>) {
  const [form, setForm] = useKept("form", ...state.form);
  const [angles, setAngles] = useKept("angles", ...state.angles);
  const [view, setView] = useKept("seen", ...state.seen);
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
