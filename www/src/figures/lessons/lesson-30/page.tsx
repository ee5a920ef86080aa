import { useMemo } from "preact/hooks";
import { Plot } from "../../kit/chart/plot";
import { studioHref } from "../../kit/frame/studio-link";
import { gasket } from "../../kit/maps/families";
import type { Point } from "../../kit/maps/pieces";
import { tex } from "../../kit/notation/tex";
import { ChoiceQuestion, Formula, type Heading, Lesson, type Prediction, useChoice } from "../frame/parts";
import { far, orbit, pushing, repeated, weighed } from "../lesson-14/orbit";
import { Track } from "../lesson-14/track";
import { Exercises } from "./exercises";
import { Leaning } from "./leaning";
import { TEACHING } from "./teaching";

/** The map of the question, and the point that it moves. */
const PUSH = pushing(0.6, 1.5);
const UP: Point = [0, 1];
const PUSH_STEPS = 12;
/** So many times what is up counts on the other ruler. */
const WEIGHT = 5;
type Fate = "away" | "home" | "ring";

/** A map that lengthens, and shrinks in the long run. */
export function Page(heading: Heading) {
  const prediction = useChoice<Fate>(OPTIONS);
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            A map shrinks if it makes every distance at most <Formula>s</Formula> times as long, for one{" "}
            <Formula>s</Formula> below 1: so it was in <a href="#learn/e14">Why maps must shrink</a>. But maps
            of shapes may stretch in one direction and press in another, or push the upper part of a picture
            to the side, as wind does with grass.
          </p>
          <p>
            This map takes 0.6 of what is across and of what is up, and then pushes to the side by what is up,
            times <Formula>k</Formula>. Change the push: the letter becomes longer in one step, although 0.6
            is well below 1. Is that a map that shrinks?
          </p>
        </>
      }
      question={<Pushed prediction={prediction} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        { name: "Map above", value: [tex`(x, y) \mapsto (0.6 x + k y,\ 0.6 y)`] },
        { name: "Map of the question", value: [tex`(x, y) \mapsto (0.6 x + 1.5 y,\ 0.6 y)`] },
        { name: "Point of the question", value: "(0, 1)" },
      ]}
      sources={
        <p>
          Gian-Carlo Rota and Gilbert Strang (<cite>A note on the joint spectral radius</cite>, 1960) proved
          when one ruler can be found by which several linear maps all shrink. John Hutchinson’s theorem
          (1981) asks for such a ruler, and not for the usual one.
        </p>
      }
      studio={{
        href: studioHref({
          a: { name: "Gasket, maps at 0.4", maps: gasket(0.4) },
          b: { name: "The same, pushed", maps: gasket(0.4).map(([a, , c, d, e, f]) => [a, 0.5, c, d, e, f]) },
        }),
      }}
    >
      <Leaning />
    </Lesson>
  );
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
      ask="With a push of 1.5, the point one above the middle comes 1.62 times as far from it in one step. What becomes of it in the long run?"
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
        By the usual ruler this map does not shrink. But count what is across plus {WEIGHT} times what is up:
        by that ruler each step leaves at most 0.9 of any distance. A ruler of one’s own is allowed, and so
        Hutchinson’s theorem (1981) holds for this map, too.
      </p>
      <p>
        Several maps need one ruler by which all of them shrink. For linear maps there is one exactly when
        their <em>joint spectral radius</em> is below 1 (Rota and Strang 1960). That is found so: of all
        products of <Formula>n</Formula> of the maps take the one that lengthens most, and the{" "}
        <Formula>n</Formula>-th root of how much it does. As <Formula>n</Formula> grows, this comes to one
        number.
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
