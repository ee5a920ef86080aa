import { useMemo } from "preact/hooks";
import { bendAt } from "#document/deform/bend";
import { fixed } from "#format/numbers";
import { lengthWords } from "#format/verdict";
import type { Bend } from "#wasm/api";
import { bends, loadBends } from "#wasm/bend";
import { Choice, SliderControl } from "../../kit/frame/control";
import { Formula } from "../../kit/frame/formula";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { tex } from "../../kit/notation/tex";
import { Bent } from "../../kit/picture/deformed";
import { number } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { Time, useTime } from "../../kit/time/time";
import { type BentPanel, bentHref } from "../deformations/deformations";
import { GASKET_MAPS } from "../deformations/gasket-maps";
import { GASKET, KE, LIFT_BOX, liftOf } from "../deformations/lifted-gasket";
import { Panels } from "../deformations/panels";
import css from "./page.module.css";

const VARIED: [number, number, number, number] = [0.5, 0.67, 0.75, 0.92];

const PANELS: readonly BentPanel[] = [
  { letter: "A", words: "plain", settings: { kb: KE, delta: 0.75 } },
  { letter: "B", words: "fractal", settings: { kb: 0, delta: 0.75 } },
  { letter: "C", words: "", settings: { kb: 1, delta: 0.75 } },
  { letter: "D", words: "", settings: { kb: 2, delta: 0.75 } },
  { letter: "E", words: "", settings: { kb: 4, delta: 0.75 } },
  { letter: "F", words: "as A", settings: { kb: KE, delta: 0.75 } },
  { letter: "G", words: "smoother", settings: { kb: 0, delta: 0.5 } },
  { letter: "H", words: "smooth to rough", settings: { kb: 0, delta: VARIED } },
];

const MOMENTS = [
  { value: "0", label: "t₀" },
  { value: "0.5", label: "t₁" },
  { value: "1", label: "t₂" },
] as const;

/** What stands in its address. */
export const STATE = {
  kb: kept(0, number(0, KE, 1)),
};

export const needs = [loadBends];

/** The gasket, bent in eight ways at once, and the slide from plain to fractal. */
export function Page(heading: Heading) {
  const time = useTime(0.75);
  const [kb, setKb] = useKept("kb", ...STATE.kb);
  const { t } = time;
  return (
    <Frame
      {...heading}
      lead={
        <p>
          In all eight the same grid is pulled: the middle of the long side is lifted. Look at the lower left
          corner. In A, which is how any drawing program bends things, it does not notice. In B it answers,
          and so does every triangle at every scale; in C to F the answer draws back to where the pull is.
          Below, one slider goes all the way from B to F.
        </p>
      }
      found={<Found />}
      parameters={[
        GASKET_MAPS,
        { name: "Detail", symbol: tex`k_e`, value: String(KE) },
        {
          name: "Roughness",
          symbol: "δ",
          value: "0.75; G 0.50; H 0.50 lower left, 0.67 lower right, 0.75 upper left",
        },
        {
          name: "Locality",
          symbol: tex`k_b`,
          value: "A plain (eq 16), B 0, C 1, D 2, E 4 (C to E reconstructed), F 9",
        },
        { name: "Control points", value: "4 × 4, of degree 3 (reconstructed)" },
        {
          name: "Time",
          symbol: "t",
          value: [
            `${fixed(t)}; `,
            tex`t_0 = 0`,
            ", ",
            tex`t_1 = \frac{1}{2}`,
            ", ",
            tex`t_2 = 1`,
            " (reconstructed)",
          ],
        },
        { name: "Corner of H that no piece reaches", value: "0.92, so that δ is even across the shape" },
      ]}
      captions={["Figure 4: Fractal deformations of a Sierpinski gasket. ke = 9."]}
      reconstructed="The maps, ke, the kb of B and F and the δ of B, G and H are printed (section 5.3, example 1, eq 18). The δ of C to F and the kb of G and H are taken to be those of B. The kb of C to E, the mesh and the moments t₁ and t₂ are not printed: they are made from the text, which has the midpoint of the hypotenuse lifted."
      differs="Neighbouring triangles are kept together at the corners they share, instead of by averages and a triangulation. In H the paper gives each part one δ; here δ changes evenly across the shape."
      studio={{ href: bentHref("Right gasket", GASKET, liftOf({ kb, phase: t })) }}
    >
      <Time time={time} words={t === 0 ? "at rest" : `${Math.round(100 * t)}% lifted`} />
      <div class={layout["controls"]}>
        <Choice
          label="Frames of the figure"
          name="The moments of frames (a), (b) and (c)"
          options={MOMENTS}
          value={MOMENTS.find(({ value }) => Number(value) === t)?.value ?? ("" as "0")}
          onChange={(value) => time.go(Number(value))}
        />
      </div>
      <Panels
        panels={PANELS}
        maps={GASKET}
        box={LIFT_BOX}
        t={t}
        columns={4}
        deformationOf={liftOf}
        name="The gasket"
        moment={`${Math.round(100 * t)}% lifted`}
      />
      <Slide t={t} kb={kb} onSlide={setKb} />
    </Frame>
  );
}

/** Section 5.4: locality between whole numbers. */
function Slide({ t, kb, onSlide }: { t: number; kb: number; onSlide: (kb: number) => void }) {
  const bend = useMemo(() => bendAt(liftOf({ kb, ke: KE }), t), [kb, t]);
  return (
    <div class={css["slide"]}>
      <h2>From B to F by one slider</h2>
      <Bent
        maps={GASKET}
        box={LIFT_BOX}
        bend={bend}
        label={`The gasket at locality ${fixed(kb)} of 9, ${Math.round(100 * t)}% lifted`}
        priority={46}
      />
      <SliderControl
        label="Locality"
        symbol={tex`k_b^*`}
        range={[0, KE]}
        step={0.1}
        value={kb}
        valueText={`kb* = ${fixed(kb)}${kb === 0 ? ", as in B" : kb === KE ? ", as in F: plain" : ""}`}
        onChange={onSlide}
        below={
          <p class={css["slide-ends"]} aria-hidden="true">
            <span>B, fractal</span>
            <span>F, plain</span>
          </p>
        }
      />
      <p class={layout["why"]}>
        Between whole numbers it is a blend of the two next to it (section 5.4, eq 19), so nothing jumps. The
        paper keeps this one for its animations.
      </p>
    </div>
  );
}

/** Where two parts of the gasket meet: the same point by two addresses. */
const JOINTS: readonly { parts: [number, number]; name: string }[] = [
  { parts: [0, 1], name: "lower left and lower right" },
  { parts: [0, 2], name: "lower left and upper left" },
  { parts: [1, 2], name: "lower right and upper left" },
];

/** How far the joints of H would come apart, were each part given one roughness for all of it. */
export function tears(t: number): { name: string; gap: number }[] {
  const at = (part: number, toward: number) => {
    const delta = VARIED[part] ?? 0;
    const corner = toward === 0 ? [0, 0] : toward === 1 ? [1, 0] : [0, 1];
    const code = [part, ...new Array<number>(KE - 1).fill(toward)];
    const bend: Bend = { ...bendAt(liftOf({ kb: 0, delta }), t), continuity: "corners" };
    const [x = 0, y = 0] = bends().deform({ maps: GASKET }, bend, [code], [corner as [number, number]]);
    return [x, y] as const;
  };
  return JOINTS.map(({ parts: [i, j], name }) => {
    const [p, q] = [at(i, j), at(j, i)];
    return { name, gap: Math.hypot(p[0] - q[0], p[1] - q[1]) };
  });
}

function Found() {
  const worst = useMemo(() => tears(1).reduce((a, b) => (b.gap > a.gap ? b : a)), []);
  return (
    <>
      <p>
        F is A, as the paper says: with <Formula tex={tex`k_b = k_e`} /> nothing is shuffled. And no crack
        opens at any <Formula tex={tex`k_b`} />, though the formula as it stands tears the shape: here every
        term is taken at the corners that triangles share, and is exactly the same on both sides.
      </p>
      <p>
        H needs care. If each of the three parts had one roughness for all of it, as the text reads, the two
        sides of a joint would disagree: {worst.name} would be {lengthWords(worst.gap)} of the side apart at{" "}
        <Formula tex={tex`t_2`} />. Here the roughness itself changes evenly across the shape, from 0.50 at
        the lower left corner to 0.67 and 0.75 at the others, and nothing tears.
      </p>
    </>
  );
}
