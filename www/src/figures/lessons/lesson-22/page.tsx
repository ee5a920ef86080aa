import { fixed } from "#format/numbers";
import { loadBends } from "#wasm/bend";
import { bentHref } from "../../fujimoto/deformations/deformations";
import { GASKET_MAPS } from "../../fujimoto/deformations/gasket-maps";
import { GASKET, KE, liftOf } from "../../fujimoto/deformations/lifted-gasket";
import { SliderControl } from "../../kit/frame/control";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { tex } from "../../kit/notation/tex";
import { number, oneOf } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { type Choice, Choices, Reply } from "../frame/choices";
import { Lesson, Question, Truth } from "../frame/lesson";
import { type Prediction, usePrediction } from "../frame/prediction";
import { DELTA, shares } from "./answer";
import { Both, Locality, Roughness } from "./bent";
import { Exercises } from "./exercises";
import { Shares } from "./shares";
import { TEACHING } from "./teaching";

type Guess = "rest" | "plain" | "weaker" | "apart";
const TRUTH: Guess = "plain";

export const needs = [loadBends];

/** The two extremes of a fractal deformation, and the two numbers that lead from one to the other. */
export function Page(heading: Heading) {
  const prediction = usePrediction<Guess>(null, oneOf(["rest", "plain", "weaker", "apart"]));
  const [kb, setKb] = useKept("locality", 0, number(0, 12, 1));
  const [pull, setPull] = useKept("pull", 1, number(0, 1, 2));
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            The middle of the long side is pulled. Each point has a code: the number of the piece that it is
            in (1 lower left, 2 lower right, 3 on top), that of the piece of the piece, and so on. In a plain
            bend it takes the pull of its own place. In a fractal bend it takes those of other places as well:
            of the codes that come from its own when the first two letters are turned round, the first three,
            and so on up to the first nine.
          </p>
          <p>
            <em>Locality</em> says how many letters are left alone at the beginning. At 0 none is: triangles
            of all sizes answer, wherever they are. At 9 all are, and only the whole answers. Drag it from one
            end to the other, and watch the far corner.
          </p>
        </>
      }
      question={<Turned prediction={prediction} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        GASKET_MAPS,
        { name: "Detail", symbol: tex`k_e`, value: String(KE) },
        { name: "Locality in the first picture", symbol: tex`k_b`, value: fixed(kb, 1) },
        { name: "Roughness in the first picture", symbol: "δ", value: String(DELTA) },
        {
          name: "Share of the level that turns j letters more",
          value: [tex`\delta^j / (1 + \delta + \dots + \delta^{k_e - k_b})`, tex`0^0 = 1`],
        },
      ]}
      sources={
        <p>
          Fujimoto, Ohno, Muraoka and Chiba, “Fractal Deformation Using Displacement Vectors Based on Extended
          Iterated Shuffle Transformation”: eqs 12, 13 and, for a locality between whole numbers, 19; their{" "}
          <a href="#figures/d4">Figure 4</a>. The question and the exercises are Frond’s.
        </p>
      }
      studio={{ href: bentHref("Right gasket", GASKET, liftOf({ kb, phase: pull })) }}
    >
      <Both kb={kb} delta={DELTA} pull={pull} />
      <div class={layout["controls"]}>
        <SliderControl label="pull" value={pull} text={`${Math.round(100 * pull)}%`} onChange={setPull} />
        <Locality value={kb} onChange={setKb} />
      </div>
    </Lesson>
  );
}

const OPTIONS: readonly Choice<Guess>[] = [
  {
    value: "rest",
    label: "Nothing: the shape lies at rest",
    wrong: "Then the shares would have to sum to less and less. Add up the bars below at any roughness.",
  },
  {
    value: "weaker",
    label: "The same as now, only weaker",
    wrong:
      "Weaker would be less pull. Here the pull is the same, and only its shares change: see the bars below.",
  },
  { value: "plain", label: "The plain bend" },
  {
    value: "apart",
    label: "Single triangles, apart",
    wrong:
      "Triangles that share a corner are given one pull there, at any roughness: turn it below, and look for a crack.",
  },
];

function Turned({ prediction }: { prediction: Prediction<Guess> }) {
  const [first = 0, second = 0, third = 0] = shares(0, DELTA).map((share) => Math.round(100 * share));
  return (
    <Question
      prediction={prediction}
      truth={TRUTH}
      beside={<Both kb={0} delta={prediction.shown ? 0 : DELTA} />}
      answer={
        <Truth line="The plain bend, exactly: the same as at locality 9.">
          <Reply options={OPTIONS} prediction={prediction} truth={TRUTH} />
          <p>
            The shares are powers of the roughness, divided by their sum. At {DELTA} the first ones are{" "}
            {first}%, {second}% and {third}%, and so on down; at 0 they are 100%, 0% and 0%. They sum to 100%
            at every roughness. So what the small levels lose is not lost: the first level gains it, and that
            turns no letter round.
          </p>
          <p>
            So there are two ways from fractal to plain. Locality says <em>who</em> answers, roughness{" "}
            <em>how loudly</em>, and each of them alone can leave the word to the whole.
          </p>
        </Truth>
      }
      after={<Loudness />}
    >
      <Choices<Guess>
        ask={`The pulls are not all taken in full. Each level, one letter more turned round, has ${DELTA} times the share of the level before. This number is called the roughness. Leave the locality at 0, and turn the roughness from ${DELTA} down to 0. What is left?`}
        options={OPTIONS}
        prediction={prediction}
        truth={TRUTH}
      />
    </Question>
  );
}

/** Roughness to play with, and the shares of the levels. */
function Loudness() {
  const [delta, setDelta] = useKept("roughness", 0.5, number(0, 2, 2));
  return (
    <>
      <Both kb={0} delta={delta} />
      <div class={layout["controls"]}>
        <Roughness value={delta} onChange={setDelta} />
      </div>
      <figure class={layout["panel"]}>
        <Shares delta={delta} />
        <figcaption>
          How the lift is shared out, by how many letters are turned round. With 0 and with 1 the code stays
          as it is.
        </figcaption>
      </figure>
    </>
  );
}
