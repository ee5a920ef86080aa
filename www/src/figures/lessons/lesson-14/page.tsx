import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { Plot } from "../../kit/chart/plot";
import { SliderControl } from "../../kit/frame/control";
import { Formula } from "../../kit/frame/formula";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { gasket } from "../../kit/maps/families";
import type { Point } from "../../kit/maps/pieces";
import { tex } from "../../kit/notation/tex";
import { number } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { ChoiceQuestion } from "../frame/choice-question";
import { Lesson } from "../frame/lesson";
import lessonCss from "../frame/lesson.module.css";
import { type Prediction, useChoice } from "../frame/prediction";
import { Exercises } from "./exercises";
import { far, orbit, pushing, repeated, timesWords, turning, weighed } from "./orbit";
import { TEACHING } from "./teaching";
import { Track } from "./track";

const DEGREES = 25;
const STEPS = 30;
const START: Point = [1, 0.3];
/** The map of the question, and the point that it moves. */
const PUSH = pushing(0.6, 1.5);
const UP: Point = [0, 1];
const PUSH_STEPS = 12;
/** So many times what is up counts on the other ruler. */
const WEIGHT = 5;
type Fate = "away" | "home" | "ring";

/** Why maps must shrink. */
export function Page(heading: Heading) {
  const prediction = useChoice<Fate>(OPTIONS);
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            This map turns the plane by {DEGREES} degrees around the ringed point, and makes every distance
            from it <Formula>s</Formula> times as long. We apply it {STEPS} times and mark where one point
            goes.
          </p>
          <p>
            Drag the scale <Formula>s</Formula>. A shape made of copies of itself needs maps that keep it
            together: what happens when a map does not shrink?
          </p>
        </>
      }
      question={<Pushed prediction={prediction} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        { name: "Map above", value: `a turn by ${DEGREES}° and a scale s, 0.5 to 1.2` },
        { name: "Map of the question", value: [tex`(x, y) \mapsto (0.6 x + 1.5 y,\ 0.6 y)`] },
        { name: "Point of the question", value: "(0, 1)" },
      ]}
      sources={
        <p>
          John Hutchinson (1981) proved for maps that shrink that they have one bounded shape of their own.
          Gian-Carlo Rota and Gilbert Strang (<cite>A note on the joint spectral radius</cite>, 1960) proved
          when one ruler can be found by which several linear maps all shrink.
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
          onChange={setScale}
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
    value: "away",
    label: "It goes away for ever, since the map makes its distance longer",
    wrong: "It does at first. But each step also takes 0.6 of what is up, and that is what it is pushed by.",
  },
  { value: "home", label: "It goes away at first, and then into the middle" },
  {
    value: "ring",
    label: "It comes to rest somewhere off the middle",
    wrong: "A place of rest has to be its own next place. For this map only the middle is.",
  },
] as const;

function Pushed({ prediction }: { prediction: Prediction<Fate> }) {
  const { shown } = prediction;
  const points = useMemo(() => orbit(repeated(PUSH, shown ? PUSH_STEPS : 1), UP), [shown]);
  return (
    <ChoiceQuestion<Fate>
      prediction={prediction}
      ask="This map takes 0.6 of what is across and of what is up, and then pushes to the side by 1.5 times what was up. In one step the point comes 1.62 times as far from the middle. What becomes of it in the long run?"
      options={OPTIONS}
      truth="home"
      beside={
        <Track
          points={points}
          reach={1.05}
          middle={[0.13, 0.8]}
          label={
            shown
              ? "The point goes to the right for two steps, comes back along the axis, and ends in the middle."
              : "A point one above the middle, and its next place: 1.5 to the right and 0.6 up."
          }
        />
      }
      after={<TwoRulers />}
      line="Away for two steps, to 1.84 times as far, and then into the middle."
    >
      <p>
        After <Formula>n</Formula> steps the point is at{" "}
        <Formula tex={tex`(1.5\, n \cdot 0.6^{n-1},\ 0.6^n)`} />. The push adds up like <Formula>n</Formula>,
        but <Formula tex={tex`0.6^n`} /> becomes small faster than <Formula>n</Formula> grows.
      </p>
      <p>
        A map <em>shrinks</em> if it makes every distance at most <Formula>s</Formula> times as long, for one{" "}
        <Formula>s</Formula> below 1. By the usual ruler this one does not. But count what is across plus{" "}
        {WEIGHT} times what is up: by that ruler each step leaves at most 0.9 of any distance. A ruler of
        one’s own is allowed, and so Hutchinson’s theorem (1981) holds for this map, too.
      </p>
      <p>
        Several maps need one ruler by which all of them shrink. For linear maps there is one exactly when
        their <em>joint spectral radius</em> is below 1 (Rota and Strang 1960). That is the number to which
        the <Formula>n</Formula>-th root of the most by which any product of <Formula>n</Formula> of them
        lengthens tends as <Formula>n</Formula> grows.
      </p>
    </ChoiceQuestion>
  );
}

/** The same way measured twice. */
function TwoRulers() {
  const points = useMemo(() => orbit(repeated(PUSH, PUSH_STEPS), UP), []);
  const plain = points.map((point, n) => [n, far(point)] as const);
  const other = points.map((point, n) => [n, weighed(point, WEIGHT) / WEIGHT] as const);
  return (
    <Plot
      label="The distance from the middle by steps. By the usual ruler it rises from 1 to 1.84 at step 2 and then falls; by the other it falls at every step."
      x={{ min: 0, max: PUSH_STEPS, ticks: [0, 2, 4, 6, 8, 10, 12], name: "step" }}
      y={{ min: 0, max: 2, ticks: [0, 0.5, 1, 1.5, 2], name: "distance, 1 at the start" }}
      series={[
        { name: "usual ruler", points: plain, colour: 0, dots: true, nameAt: 3, raise: 10 },
        {
          name: "across plus 5 times up",
          points: other,
          colour: 1,
          dots: true,
          dashed: true,
          nameAt: 5,
          raise: -20,
        },
      ]}
    />
  );
}
