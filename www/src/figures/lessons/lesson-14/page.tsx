import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { Plot } from "../../kit/chart/plot";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { gasket } from "../../kit/maps/families";
import type { Point } from "../../kit/maps/pieces";
import { tex } from "../../kit/notation/tex";
import { number, whole } from "../../kit/state/fields";
import lessonCss from "../frame/lesson.module.css";
import {
  ChoiceQuestion,
  Formula,
  type Heading,
  Lesson,
  type Prediction,
  useChoice,
  useKept,
} from "../frame/parts";
import { Exercises } from "./exercises";
import { far, metresWords, orbit, repeated, timesWords, turning } from "./orbit";
import { TEACHING } from "./teaching";
import { Track } from "./track";

const DEGREES = 25;
const STEPS = 30;
const START: Point = [1, 0.3];
/** The factor of the question, and how often it is applied. */
const SLOW = 0.99;
const MANY = 1000;
type Left = "most" | "tenth" | "hair" | "nothing";

/** Why maps must shrink. */
export function Page(heading: Heading) {
  const prediction = useChoice<Left>(OPTIONS);
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            All maps so far made smaller copies: half as large in the triangle, 0.85 times as large in the
            fern. Must they? This map turns the plane by {DEGREES} degrees around the ringed point, and makes
            every distance from it <Formula>s</Formula> times as long.
          </p>
          <p>
            It is applied {STEPS} times, and marks show where one point goes. Drag the scale{" "}
            <Formula>s</Formula>, and find out from where on it does not come home.
          </p>
        </>
      }
      question={<Slowly prediction={prediction} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        { name: "Map above", value: `a turn by ${DEGREES}° and a scale s, 0.5 to 1.2` },
        { name: "Scale in the question", symbol: "s", value: String(SLOW) },
        { name: "Map of the second exercise", value: [tex`x \mapsto \tfrac12 x + 3`] },
      ]}
      sources={
        <p>
          Stefan Banach (1922) proved that a map which shrinks leaves exactly one point in place, and that all
          others come to it, step by step. John Hutchinson (<cite>Fractals and self similarity</cite>, 1981)
          proved the same of several maps and figures: they have one bounded shape of their own, and every
          start comes to it.
        </p>
      }
      studio={{
        href: studioHref({
          a: { name: "Gasket, maps at 0.4", maps: gasket(0.4) },
          b: preset("gasket"),
        }),
      }}
    >
      <Spiral />
    </Lesson>
  );
}

/** One slider, from far below 1 to above it. */
function Spiral() {
  const [scale, setScale] = useKept("scale", 0.9, number(0.5, 1.2, 2));
  const points = useMemo(() => orbit(repeated(turning(scale, DEGREES), STEPS), START), [scale]);
  const words = scaleWords(scale);
  // All of the way is seen, also of one that leads away.
  const reach = Math.max(1.6, 1.1 * far(points.at(-1) ?? START));
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <Track
        points={points}
        reach={reach}
        label={`A point and its ${STEPS} next places at scale ${fixed(scale)}. ${words}`}
      />
      <div class={lessonCss["ask"]}>
        <SliderControl
          label="scale of the map"
          symbol="s"
          range={[0.5, 1.2]}
          value={scale}
          // What is read is what it is: 0.995 is not 1.
          onChange={(next) => setScale(Number(next.toFixed(2)))}
        />
        <p aria-live="polite">{words}</p>
        <p class="number">
          After 10 steps: {timesWords(scale ** 10)} times as far.
          <br />
          After {STEPS} steps: {timesWords(scale ** STEPS)} times as far.
        </p>
      </div>
    </div>
  );
}

function scaleWords(scale: number): string {
  if (Math.abs(scale - 1) < 0.0005) return "At 1 the point keeps its distance for ever.";
  return scale < 1
    ? "Below 1 every point comes nearer with each step."
    : "Above 1 every point but the middle goes away, without end.";
}

const OPTIONS = [
  {
    value: "most",
    label: "Still more than half a metre: it hardly shrinks",
    wrong: "So it is after 60 steps. But each step takes a hundredth of what is left: drag the steps below.",
  },
  {
    value: "tenth",
    label: "About 10 centimetres",
    wrong: "There they are after 230 steps, and they go on. Drag the steps below.",
  },
  { value: "hair", label: "Less than a tenth of a millimetre" },
  {
    value: "nothing",
    label: "Nothing: they have met",
    wrong: "0.99 times a length is never nothing: they come as near as you like, and never meet.",
  },
] as const;

function Slowly({ prediction }: { prediction: Prediction<Left> }) {
  return (
    <ChoiceQuestion<Left>
      prediction={prediction}
      ask="A map shrinks hardly at all: it makes every distance 0.99 times as long. Two points are 1 metre apart. How far apart are they after a thousand steps?"
      options={OPTIONS}
      truth="hair"
      after={<Factors />}
      line="0.043 millimetres: less than a tenth of a millimetre."
    >
      <p>
        Each step leaves 0.99 of what is there, so <Formula>n</Formula> steps leave{" "}
        <Formula tex={tex`0.99^n`} />. Every 69 steps half of it is gone, and half of the half, and so on. Any
        factor below 1 does it, if one waits. At exactly 1 nothing comes nearer, ever, and above 1 all that is
        apart flies apart.
      </p>
      <p>
        So one says that a map <em>shrinks</em> if it makes every distance at most <Formula>s</Formula> times
        as long, for one fixed <Formula>s</Formula> below 1. If all maps of a shape do, each step brings any
        two starts nearer to each other: that is why they all lead to one shape. With a map that does not,
        there may be none, or more than one.
      </p>
    </ChoiceQuestion>
  );
}

const FACTORS = [0.9, 0.99, 0.999, 1] as const;
const SAMPLES = Array.from({ length: 101 }, (_, i) => (MANY * i) / 100);

/** How a distance goes down, by its factor. */
function Factors() {
  const [steps, setSteps] = useKept("steps", 100, whole(0, MANY));
  // A length stays with its unit, and with its factor.
  const left = FACTORS.map((factor) =>
    `${factor}: ${metresWords(factor ** steps)}`.replaceAll(" ", "\u00a0"),
  ).join("; ");
  return (
    <>
      <Plot
        label={`A distance of 1 metre by steps: by factor 0.9 it is gone at once, by 0.99 within some hundred steps, by 0.999 it is 37 centimetres after a thousand, by 1 it stays. Left after ${steps} steps, by factor: ${left}.`}
        x={{ min: 0, max: MANY, ticks: [0, 200, 400, 600, 800, 1000], name: "steps" }}
        y={{ min: 0, max: 1.1, ticks: [0, 0.25, 0.5, 0.75, 1], name: "metres apart" }}
        series={FACTORS.map((factor, i) => ({
          name: String(factor),
          points: SAMPLES.map((n) => [n, factor ** n] as const),
          colour: i,
          nameAt: [6, 12, 50, 90][i] ?? 0,
        }))}
        now={steps}
      />
      <div class={layout["controls"]}>
        <SliderControl label="steps" symbol="n" range={[0, MANY]} whole value={steps} onChange={setSteps} />
      </div>
      <p class="number" aria-live="polite">
        Of 1 metre there is left after {steps} {steps === 1 ? "step" : "steps"}, with the factor {left}.
      </p>
    </>
  );
}
