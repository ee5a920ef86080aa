import { useCallback, useMemo } from "preact/hooks";
import { bendAt } from "#document/deform/bend";
import type { Box } from "#document/framing";
import { fixed } from "#format/numbers";
import type { Deformation, Spin } from "#wasm/api";
import { loadBends } from "#wasm/bend";
import { Choice } from "../../kit/frame/control";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import type { Point } from "../../kit/maps/pieces";
import { tex } from "../../kit/notation/tex";
import { oneOf } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { type BentPanel, bentHref } from "../deformations/deformations";
import { LettersPanel } from "../deformations/letters-panel";
import { type Lens, Magnified, WithFrames } from "../deformations/magnified";
import magnifiedCss from "../deformations/magnified.module.css";
import { Panels } from "../deformations/panels";
import { FERN, KE, SPIN, swayOf } from "./fern";
import { Sway, useSway } from "./sway";

const BOX: Box = { x0: -5.3, y0: -0.5, x1: 5.3, y1: 10.4 };
const ASPECT = (BOX.x1 - BOX.x0) / (BOX.y1 - BOX.y0);
const SHAPE = { maps: FERN, box: BOX, aspect: ASPECT };
/**
 * The fern itself, and where the names of its pieces stand: in the middle, on the two lowest leaves, and on the stem.
 */
const BOX_AT_REST: Box = { x0: -2.2, y0: 0, x1: 2.7, y1: 10 };
const NAMES: readonly Point[] = [
  [0.4, 5.6],
  [-1.15, 2.6],
  [1.2, 1.9],
  [0, 0.6],
];

const PANELS: readonly BentPanel[] = [
  { letter: "A", words: "plain", settings: { kb: KE, delta: 0.75 } },
  { letter: "B", words: "fractal", settings: { kb: 0, delta: 0.75 } },
  { letter: "C", words: "", settings: { kb: 1, delta: 0.65 } },
  { letter: "D", words: "", settings: { kb: 2, delta: 0.55 } },
  { letter: "E", words: "", settings: { kb: 4, delta: 0.45 } },
];
const B = PANELS[1]?.settings ?? {};

/** Letters that lead up the fern, piece after piece. */
const up = (count: number) => new Array<number>(count).fill(0);
const LENSES: readonly Lens[] = [
  { number: 1, kind: "red", about: "a leaf in the middle", code: [...up(3), 2, ...up(5)], width: 2.2 },
  { number: 2, kind: "blue", about: "the lowest leaf", code: [1, ...up(5)], width: 3 },
  { number: 3, kind: "green", about: "the tip", code: up(12), width: 2.2 },
];

const SPINS = [
  { value: "rotation", label: "Rotation", description: "the rotation, with reflections split off" },
  { value: "orthogonal", label: "Orthogonal", description: "the orthogonal factor, reflections included" },
  { value: "scaled", label: "Scaled", description: "by A / ‖A‖: less across a flat map" },
  { value: "none", label: "None", description: "displacements keep their direction" },
] as const;

/** As the paper words it: by "the rotation factors" of the maps. */

/** What stands in its address. */
export const STATE = {
  spin: kept<Spin>(SPIN, oneOf(SPINS.map(({ value }) => value))),
};

export const needs = [loadBends];

/** The fern in the wind. */
export function Page(heading: Heading) {
  const sway = useSway(0.2);
  const [spin, setSpin] = useKept("spin", ...STATE.spin);
  const deformationOf = useCallback(
    (settings: Partial<Deformation>) => swayOf({ ...settings, spin }),
    [spin],
  );
  const bend = useMemo(() => bendAt(swayOf({ ...B, spin }), sway.t), [spin, sway.t]);
  const framed = { name: "B", ...SHAPE, bend, lenses: LENSES };
  return (
    <Frame
      {...heading}
      lead={
        <p>
          A grid sways a fern’s upper part from side to side. Press play. A goes with the grid, stiff as a
          board. In B every leaf sways about its own stem, and every leaflet about its leaf’s, since the
          displacement that reaches a part is turned as the part is; look at the magnified parts. From C to E
          the sway draws back to the upper part.
        </p>
      }
      found={
        <p>
          The paper turns the displacements by “the rotation factors” of the maps and does not say what those
          are for a map that also shears, mirrors, or is flat, as the stem’s is. Here a mirror image is split
          off first, and the stem’s map does not turn; other answers are to choose from above. Dividing each
          matrix by its largest stretch needs no cases, and is the same for all maps that only turn and scale.
          Nothing is kept together here: a leaf is free to sway about the point that it hangs on, and where
          the sway is rough it may come off.
        </p>
      }
      parameters={[
        { name: "Maps", symbol: tex`f_i`, value: "the paper’s four, in its order" },
        { name: "Detail", symbol: tex`k_e`, value: String(KE) },
        {
          name: "Locality",
          symbol: tex`k_b`,
          value: "A plain (eq 16), B 0, C 1, D 2, E 4 (C to E reconstructed)",
        },
        {
          name: "Roughness",
          symbol: "δ",
          value: ["0.75, 0.65, 0.55, 0.45 (reconstructed: smaller as ", tex`k_b`, " grows)"],
        },
        { name: "Rotation", value: SPINS.find(({ value }) => value === spin)?.description ?? "" },
        { name: "Control points", value: "4 × 4 over [−3, 3] × [0, 10.2] (reconstructed)" },
        { name: "Time", symbol: "t", value: `${fixed(sway.t)} of one sway` },
      ]}
      captions={["Figure 5: Fractal deformations of a Black Spleenwort fern. ke = 6."]}
      reconstructed="The maps, ke and the kb of B are printed (section 5.3, example 2, eq 18), and that δ falls as kb grows. The mesh, the other kb, all values of δ and the magnified parts, whose frames go with what they show, are made from the text. Of (X), the addressing rule, only the order of the maps is known."
      studio={{ href: bentHref("Black spleenwort fern", FERN, swayOf({ ...B, spin, phase: sway.t })) }}
    >
      <Sway sway={sway} />
      <div class={layout["controls"]}>
        <Choice<Spin> label="Rotation" options={SPINS} value={spin} onChange={setSpin} />
      </div>
      <Panels
        {...SHAPE}
        panels={PANELS}
        t={sway.t}
        columns={3}
        deformationOf={deformationOf}
        name="The fern"
        moment={`at ${fixed(sway.t)} of one sway`}
      >
        <WithFrames {...framed} />
      </Panels>
      <Magnified {...framed} />
      <div class={magnifiedCss["magnified"]}>
        <Addresses />
      </div>
    </Frame>
  );
}

/** The addressing rule: each piece by the letter of its map. */
function Addresses() {
  const rest = useMemo(() => bendAt(swayOf({ kb: KE }), 0), []);
  return (
    <LettersPanel
      maps={FERN}
      rest={rest}
      box={BOX_AT_REST}
      aspect={ASPECT}
      names={NAMES}
      label="The fern at rest: the part of map 1 is all but the lowest leaves, map 2 has the left one of them, map 3 the right one, and map 4 the stem"
    />
  );
}
