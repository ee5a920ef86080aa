import { EPSILON } from "#compute/locus/job";
import type { LocusResult } from "#compute/results";
import { resolutionWords } from "#format/verdict";
import { Formula } from "../../kit/frame/formula";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { tex } from "../../kit/notation/tex";
import { oneOf } from "../../kit/state/fields";
import { type Choice, Choices, Reply } from "../frame/choices";
import { Lesson, Question, Truth } from "../frame/lesson";
import { type Prediction, usePrediction } from "../frame/prediction";
import { Chart, Legend } from "./chart";
import { Exercises } from "./exercises";
import { Here, usePlace } from "./here";
import { FROM, MARKED, TO, TRUTH, type Which } from "./map";
import { SIZE, useProved } from "./proved";
import { TEACHING } from "./teaching";
import { Touching } from "./touching";

/** How a map of shapes is read. */
export function Page(heading: Heading) {
  const prediction = usePrediction<Which>(null, oneOf(["1", "2", "3", "none"]));
  const { field, proved } = useProved(prediction.shown);
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            Shape A, a dragon, and shape B, the gasket, are made of three maps each. Between them there is not
            a row of shapes but a whole map. Its first number <Formula>u</Formula> says how far the three maps
            have been turned and stretched on the way from A to B, its second number <Formula>v</Formula> how
            far they have been moved. A is at (0, 0) and B at (1, 1); the map goes on beyond both.
          </p>
          <p>
            The map below is still empty. Touch it anywhere, or drag the ring: you see the shape of that
            place, and a mark stays. All places whose shape is in one piece are together called the{" "}
            <em>connectedness locus</em> of A and B.
          </p>
        </>
      }
      question={<Whole prediction={prediction} field={field} proved={proved} />}
      exercises={<Exercises field={field} />}
      teaching={TEACHING}
      parameters={[
        { name: "Shape A", value: "Heighway’s dragon, written with three maps" },
        { name: "Shape B", value: "the gasket" },
        { name: "The map", symbol: tex`(u, v)`, value: "from −1 to 2 each" },
        { name: "Samples of the map", value: `${SIZE} × ${SIZE}` },
        { name: "Resolution of the map", symbol: "ε", value: `${resolutionWords(EPSILON)} of the shape` },
        { name: "Resolution of a touch", symbol: "ε", value: [tex`10^{-6}`, " of the shape"] },
      ]}
      sources={
        <p>
          The two numbers and the connectedness locus are Burch and Hart’s (1997), and so is this pair of
          shapes: their <a href="#figures/7">Figure 7</a>. That a whole shape is told by its pieces, and
          whether they hang together by touching, is Masayoshi Hata’s theorem (1985). The verdicts, the proofs
          and the widths of the gaps are Frond’s.
        </p>
      }
      studio={{ href: studioHref({ a: preset(FROM), b: preset(TO), t: 0.5 }) }}
    >
      <Touching />
    </Lesson>
  );
}

const OPTIONS: readonly Choice<Which>[] = [
  {
    value: "1",
    label: "1: it is the nearest to B",
    wrong: "Near to B, yes; but look at its shape below: a small step from B has opened a gap.",
  },
  {
    value: "2",
    label: "2: half-way on the straight line",
    wrong: "Between two whole shapes nothing is promised: look at its shape below.",
  },
  { value: "3", label: "3: far from the line" },
  {
    value: "none",
    label: "None of the three",
    wrong:
      "Two of them are in pieces. Look at the shape of the third below: its pieces lie across each other.",
  },
];

interface WholeProps {
  prediction: Prediction<Which>;
  field: LocusResult | null;
  proved: boolean;
}

function Whole({ prediction, field, proved }: WholeProps) {
  const { shown } = prediction;
  return (
    <Question
      prediction={prediction}
      truth={TRUTH}
      beside={
        <Chart
          field={shown ? field : null}
          label="The map of shapes with the places 1, 2 and 3. Light: in one piece. The darker, the wider the gap."
          marked
        />
      }
      answer={
        <Truth line={"Place 3, and it alone: the one that is far from both."}>
          <Reply options={OPTIONS} prediction={prediction} truth={TRUTH} />
          <p>
            That a place is near to a whole shape promises nothing. The pieces of B touch in single points, so
            most small changes part them: B lies on the very border of what is whole. At 3 the pieces lie
            across each other, and a small push does not part what crosses.
          </p>
        </Truth>
      }
      after={<Read field={field} proved={proved} />}
    >
      <Choices<Which>
        ask="A and B are both in one piece. Which of the marked places has a shape in one piece, too?"
        options={OPTIONS}
        prediction={prediction}
        truth={TRUTH}
      />
    </Question>
  );
}

/** The three shapes, and what the colours of the map say. */
function Read({ field, proved }: { field: LocusResult | null; proved: boolean }) {
  return (
    <>
      <div class={layout["triple"]}>
        {MARKED.map((marked) => (
          <Marked key={marked.name} {...marked} />
        ))}
      </div>
      <p class={layout["why"]}>
        The machine has now touched the map {SIZE} times {SIZE} times, and coloured each sample by what it
        found{field?.progress === 1 && !proved ? "; it is still looking for proofs" : ""}. A colour is a
        claim, and there are four of them:
      </p>
      <Legend epsilon={EPSILON} />
    </>
  );
}

function Marked({ name, at }: (typeof MARKED)[number]) {
  const place = usePlace(at);
  return (
    <Panel name={name} words={`u = ${at[0]}, v = ${at[1]}`}>
      <Here at={at} of={place} />
    </Panel>
  );
}
