import { useMemo } from "preact/hooks";
import { bendAt } from "#document/deform/bend";
import { fixed } from "#format/numbers";
import { bentHref } from "../../fujimoto/deformations/deformations";
import { GASKET_MAPS } from "../../fujimoto/deformations/gasket-maps";
import { FAR_CORNER, GASKET, KE, LIFT_BOX, liftOf } from "../../fujimoto/deformations/lifted-gasket";
import { SliderControl } from "../../kit/frame/control";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { tex } from "../../kit/notation/tex";
import { Bent } from "../../kit/picture/deformed";
import { number, oneOf } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { type Choice, Choices, Reply } from "../frame/choices";
import { Lesson, Question, Truth } from "../frame/lesson";
import { type Prediction, usePrediction } from "../frame/prediction";
import { Exercises } from "./exercises";
import { TEACHING } from "./teaching";

type Guess = "still" | "along" | "alike" | "apart";
const TRUTH: Guess = "alike";
const OPTIONS: readonly Choice<Guess>[] = [
  {
    value: "still",
    label: "Nothing: it is too far from the pull",
    wrong: "In a plain bend it is. Here a point takes the pull of another place, however far that is.",
  },
  {
    value: "along",
    label: "The corner is shifted as a whole",
    wrong: "Then all of its parts would have to take one pull. But each has a code of its own.",
  },
  { value: "alike", label: "Each triangle is lifted in the middle of its own long side" },
  {
    value: "apart",
    label: "They come apart",
    wrong: "Triangles that share a corner are given one pull there: look for a crack below.",
  },
];

/** Plain or fractal. */
export function Page(heading: Heading) {
  const prediction = usePrediction<Guess>(null, oneOf(["still", "along", "alike", "apart"]));
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            Bend a drawing by a grid, and what is near the pull moves most, what is far hardly at all. Below,
            the middle of the long side is lifted: the corner at the lower left does not notice.
          </p>
          <p>
            Now every point trades its place in the list. Its code (which piece, which part of the piece, and
            so on) is read the other way round, and it takes the pull of the point that it finds there. A
            little of that is mixed in at every length of code, from the large pieces down to the small.
          </p>
        </>
      }
      question={<What prediction={prediction} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        GASKET_MAPS,
        { name: "Roughness", symbol: "δ", value: "0.75" },
        { name: "Detail", symbol: tex`k_e`, value: String(KE) },
        { name: "Locality", symbol: tex`k_b`, value: "0 fractal, 9 plain" },
      ]}
      sources={
        <p>
          Fujimoto, Ohno, Muraoka and Chiba, “Fractal Deformation Using Displacement Vectors Based on Extended
          Iterated Shuffle Transformation”, section 5.3 and eq 18; their <a href="#figures/d4">Figure 4</a>.
          The question is Frond’s.
        </p>
      }
      studio={{ href: bentHref("Right gasket", GASKET, liftOf({ kb: 0, phase: 1 })) }}
    >
      <Plain />
    </Lesson>
  );
}

const useBend = (kb: number, t: number) => useMemo(() => bendAt(liftOf({ kb }), t), [kb, t]);

/** At rest, and bent as any drawing is. */
function Plain() {
  const [rest, plain] = [useBend(KE, 0), useBend(KE, 1)];
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <Panel caption="at rest, with its grid">
        <Bent maps={GASKET} box={LIFT_BOX} bend={rest} label="The gasket at rest, with its grid" />
      </Panel>
      <Panel caption="plain: the middle of the long side is lifted">
        <Bent
          maps={GASKET}
          box={LIFT_BOX}
          bend={plain}
          label="The gasket, plainly bent: its middle is lifted"
        />
      </Panel>
    </div>
  );
}

function What({ prediction }: { prediction: Prediction<Guess> }) {
  const bend = useBend(KE, 1);
  return (
    <Question
      prediction={prediction}
      truth={TRUTH}
      beside={
        <Bent
          maps={GASKET}
          box={FAR_CORNER}
          bend={bend}
          grid={0}
          label="The lower left corner, nearly fifteen times larger, plainly bent: it is as it was"
        />
      }
      answer={
        <Truth line="Every triangle there answers, at every scale, with a lift of its own.">
          <Reply options={OPTIONS} prediction={prediction} truth={TRUTH} />
          <p>
            With 1 at the lower left, 2 at the right and 3 on top, the parts next to the middle of a long side
            are 23 and 32. A small part next to the middle of a small triangle has a code that ends so: 1123,
            say. Read the other way round it is 3211, a part of 32, and that lies next to the middle of the
            whole. So it takes the pull from there, and so it is in every triangle of every size. Nothing
            comes apart, because the corners that triangles share are given one pull for both.
          </p>
        </Truth>
      }
      after={<After />}
    >
      <Choices<Guess>
        ask="This is the far corner, fifteen times larger, still plainly bent. What becomes of its small triangles when the pull is shuffled so?"
        options={OPTIONS}
        prediction={prediction}
        truth={TRUTH}
      />
    </Question>
  );
}

/** Both views with the slide from fractal to plain. */
function After() {
  const [kb, setKb] = useKept("locality", 0, number(0, KE, 1));
  const bend = useBend(kb, 1);
  return (
    <>
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Panel caption="the whole">
          <Bent maps={GASKET} box={LIFT_BOX} bend={bend} label={`The gasket at locality ${fixed(kb)} of 9`} />
        </Panel>
        <Panel caption="the far corner, nearly fifteen times larger">
          <Bent
            maps={GASKET}
            box={FAR_CORNER}
            bend={bend}
            grid={0}
            label={`The lower left corner at locality ${fixed(kb)} of 9`}
          />
        </Panel>
      </div>
      <div class={layout["controls"]}>
        <SliderControl
          label="Locality"
          symbol={tex`k_b`}
          range={[0, KE]}
          step={0.1}
          value={kb}
          onChange={setKb}
        />
      </div>
      <p>
        Locality says how many letters of the code stay as they are: at 1 a point trades only within its own
        third, at 2 within its own ninth, and at 9 not at all, which is the plain bend again.
      </p>
    </>
  );
}
