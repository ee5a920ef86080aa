import { useMemo } from "preact/hooks";
import { bendAt } from "#document/deform/bend";
import type { Box } from "#document/framing";
import { fixed } from "#format/numbers";
import { loadBends } from "#wasm/bend";
import { Formula } from "../../kit/frame/formula";
import { Frame, type Heading } from "../../kit/frame/frame";
import { Panel } from "../../kit/frame/panel";
import { tex } from "../../kit/notation/tex";
import { middles } from "../../kit/picture/annotated";
import { Bent } from "../../kit/picture/deformed";
import { Time, useTime } from "../../kit/time/time";
import { type BentPanel, bentHref } from "../deformations/deformations";
import { LettersPanel } from "../deformations/letters-panel";
import { type Lens, Magnified, WithFrames } from "../deformations/magnified";
import magnifiedCss from "../deformations/magnified.module.css";
import { Panels } from "../deformations/panels";
import { drawnOf, KE, PLAIN_TINT, TWIN } from "./drawn-dragon";

const BOX: Box = { x0: -1.05, y0: -1.42, x1: 2.9, y1: 1.75 };
/** The dragon itself. */
const BOX_AT_REST: Box = { x0: -0.77, y0: -0.42, x1: 1.77, y1: 1.42 };
const ASPECT = (BOX.x1 - BOX.x0) / (BOX.y1 - BOX.y0);
const SHAPE = { maps: TWIN, box: BOX, aspect: ASPECT };

const PANELS: readonly BentPanel[] = [
  { letter: "A", words: "plain", settings: { kb: KE } },
  { letter: "B", words: "fractal", settings: { kb: 0 } },
  { letter: "C", words: "", settings: { kb: 2 } },
  { letter: "D", words: "", settings: { kb: 4 } },
  { letter: "E", words: "", settings: { kb: 6 } },
];
const B = PANELS[1]?.settings ?? {};

const letters = (code: string) => [...code].map(Number);
const LENSES: readonly Lens[] = [
  { number: 1, kind: "red", about: "the tip on the left", code: letters("0001010000"), width: 1 },
  { number: 2, kind: "black", about: "the middle", code: letters("0100000000"), width: 1 },
  { number: 3, kind: "green", about: "the tip at the lower right", code: letters("1111010000"), width: 1 },
];

export const needs = [loadBends];

/** The twin-dragon with colours of its own. */
export function Page(heading: Heading) {
  const time = useTime(0.8);
  const { t } = time;
  const bend = useMemo(() => bendAt(drawnOf(B), t), [t]);
  const colours = useMemo(() => bendAt(drawnOf({ ...PLAIN_TINT }), 0), []);
  const framed = { name: "B", ...SHAPE, bend, colouring: "grid", lenses: LENSES } as const;
  return (
    <Frame
      {...heading}
      lead={
        <p>
          The lower right part of a dragon is drawn to the lower right. In A only that part goes. In B each
          spiral tip, at every scale, winds inwards and shrinks on its own; from C to E the pull draws back to
          where it acts. The colours are shuffled just as the pull is, so that one sees which parts answer
          alike.
        </p>
      }
      found={
        <p>
          Twin-dragons tile the plane, and their pieces have no corners to hold on to. Here each term is
          spread over a small grid of the plane and read off between its points, so that both sides of a
          border get the same, and no crack opens at any <Formula tex={tex`k_b`} />. With{" "}
          <Formula tex={tex`\delta = 1`} /> all {KE + 1} terms of B count alike.
        </p>
      }
      parameters={[
        { name: "Maps", symbol: tex`f_1, f_2`, value: "the paper’s two" },
        { name: "Detail", symbol: tex`k_e`, value: String(KE) },
        { name: "Roughness", symbol: "δ", value: "1" },
        { name: "Locality", symbol: tex`k_b`, value: "A plain (eq 16), B 0, C 2, D 4, E 6 (reconstructed)" },
        { name: "Rotation", value: ["by the maps from ", tex`k_b + 1`, " on: both turn by −45°"] },
        {
          name: "Colours",
          symbol: tex`F_c`,
          value: "eq 12 with kb 0, ke 8, δc 1; the 4 × 4 colours are reconstructed",
        },
        { name: "Control points", value: "4 × 4 over [−1, 2] × [−0.7, 1.7] (reconstructed)" },
        { name: "Time", symbol: "t", value: fixed(t) },
      ]}
      captions={["Figure 6: Fractal deformations of a Twin-Dragon. ke = 8. δv(s) = 1."]}
      reconstructed="The maps, ke, δ and the numbers of the colouring are printed (section 5.3, example 3, eqs 12 and 18). The mesh, the colour function (Y), the kb of the panels and the magnified parts are made from the text. Of (X), the addressing rule, only the order of the maps is known."
      studio={{ href: bentHref("Twin-dragon of the paper", TWIN, drawnOf({ ...B, phase: t })) }}
    >
      <Time time={time} words={t === 0 ? "at rest" : `${Math.round(100 * t)}% drawn`} />
      <Panels
        {...SHAPE}
        panels={PANELS}
        t={t}
        columns={3}
        colouring="grid"
        deformationOf={drawnOf}
        name="The twin-dragon"
        moment={`${Math.round(100 * t)}% drawn`}
      >
        <WithFrames {...framed} />
      </Panels>
      <Magnified {...framed} />
      <div class={magnifiedCss["magnified"]}>
        <LettersPanel
          {...SHAPE}
          rest={colours}
          names={middles(TWIN, BOX_AT_REST)}
          label="The dragon at rest: the part of map 1 on the left, that of map 2 on the right"
        />
        <Panel name="Y" words="the colours before the shuffle">
          <Bent
            {...SHAPE}
            bend={colours}
            colouring="grid"
            label="The colour function on the dragon at rest, before it is shuffled"
          />
        </Panel>
      </div>
    </Frame>
  );
}
