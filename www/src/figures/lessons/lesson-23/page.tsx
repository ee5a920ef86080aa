import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { Plot } from "../../kit/chart/plot";
import { SliderControl } from "../../kit/frame/control";
import { Formula } from "../../kit/frame/formula";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { tex } from "../../kit/notation/tex";
import { number } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { ChoiceQuestion } from "../frame/choice-question";
import { Lesson } from "../frame/lesson";
import { type Prediction, useChoice } from "../frame/prediction";
import { bound, GOOD, mapOf } from "./collage";
import { HowLarge, Promise25 } from "./exercises";
import { Game, madeWords, useCollage, useMade } from "./game";
import { CELL } from "./raster";
import { TEACHING } from "./teaching";

/** The collage theorem. */
export function Page(heading: Heading) {
  const prediction = useChoice<Most>(OPTIONS);
  const made = useMemo(() => ({ name: "Covered leaf", maps: GOOD.map(mapOf) }), []);
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            So far there were maps first, and then the shape that they make. Now it is the other way round:
            here is a leaf, and maps are wanted that make it. The trick is to cover the leaf with smaller
            copies of itself. Each copy is a map: it says where the whole leaf goes.
          </p>
          <p>
            Drag the copies, and turn and size them by the round grip, so that they cover the leaf and stick
            out nowhere. The red line shows where it is worst. Then see what these maps make.
          </p>
        </>
      }
      question={<HowFar prediction={prediction} />}
      exercises={
        <>
          <Promise25 />
          <HowLarge />
        </>
      }
      teaching={TEACHING}
      parameters={[
        { name: "Leaf", symbol: "L", value: "a polygon of 28 corners, 1 high" },
        {
          name: "Distance",
          symbol: "h",
          value: "Hausdorff’s: the worst distance of a point of one to the other",
        },
        {
          name: "Measured",
          value: `on a grid with cells of ${CELL}, right to about 0.02; what the maps make by 50 000 of its points`,
        },
        { name: "Shrinking factor", symbol: "s", value: "the size of the largest copy, at most 0.75" },
      ]}
      sources={
        <p>
          The collage theorem is due to Michael Barnsley, Vincent Ervin, Douglas Hardin and John Lancaster (
          <cite>Solution of an inverse problem for fractals and other sets</cite>, 1986), and stands in
          Barnsley’s <cite>Fractals Everywhere</cite> (1988): if all maps{" "}
          <Formula tex={tex`f_1, \dots, f_N`} /> shrink distances by a factor of at most <Formula>s</Formula>{" "}
          below 1, and <Formula>A</Formula> is their attractor, then{" "}
          <Formula tex={tex`h(L, A) \le \frac{h(L,\, f_1(L) \cup \dots \cup f_N(L))}{1 - s}`} copy /> for
          every set <Formula>L</Formula> that is bounded, closed and not empty. The leaf is Frond’s own.
        </p>
      }
      studio={{ href: studioHref({ a: made, b: preset("maple") }) }}
    >
      <First />
    </Lesson>
  );
}

function First() {
  const collage = useCollage("copies");
  const made = useMade(collage.maps);
  return (
    <Game collage={collage}>
      <p class="number">
        The copies together are {fixed(collage.collage?.distance ?? 0)} off the leaf, which is 1 high. What
        they make is {madeWords(made)} off.
      </p>
    </Game>
  );
}

type Most = "same" | "double" | "any";
const OPTIONS = [
  {
    value: "same",
    label: "1 mm, like the collage",
    wrong:
      "The collage is made of copies of the perfect leaf. What the maps make is made of copies of itself, which are off already.",
  },
  { value: "double", label: "2 mm" },
  {
    value: "any",
    label: "Any distance: the small faults pile up without end",
    wrong:
      "They pile up without end, but each is half of the one before. Add a half, a quarter, an eighth and so on.",
  },
] as const;

function HowFar({ prediction }: { prediction: Prediction<Most> }) {
  return (
    <ChoiceQuestion<Most>
      prediction={prediction}
      ask="Somebody covers a leaf with four copies, each half as large as the leaf, so well that the collage is nowhere more than 1 mm off. How far off can what the maps make be, at most?"
      options={OPTIONS}
      truth="double"
      after={<Promised />}
      line="At most 2 mm: 1 + 1/2 + 1/4 + 1/8 + … = 2."
    >
      <p>
        Say that what the maps make is <Formula>d</Formula> off the leaf. It is made of copies of itself, the
        collage of copies of the leaf: half as large, so these two are at most <Formula tex={tex`d/2`} />{" "}
        apart. The collage is at most 1 mm off the leaf. Together <Formula>d</Formula> is at most{" "}
        <Formula tex={tex`1 + d/2`} />, and so at most 2.
      </p>
      <p>
        With copies of at most <Formula>s</Formula> times the size it is{" "}
        <Formula tex={tex`d \le c / (1 - s)`} />, where <Formula>c</Formula> is how far the collage is off.
        This promise is the collage theorem (Barnsley and others 1986). Whoever covers a shape well has found
        maps that make nearly that shape.
      </p>
    </ChoiceQuestion>
  );
}

const STEPS = Array.from({ length: 46 }, (_, i) => i / 50);

/** What is promised, by the size of the largest copy. */
function Promised() {
  const [s, setS] = useKept("s", 0.5, number(0, 0.9, 2));
  const times = bound(1, s);
  return (
    <>
      <Plot
        label={`What is promised, in distances of the collage, by the size of the largest copy: 1 at size 0, 2 at 0.5, 10 at 0.9. At ${fixed(s)} it is ${fixed(times)}.`}
        x={{ name: "largest copy s", min: 0, max: 0.9, ticks: [0, 0.25, 0.5, 0.75, 0.9] }}
        y={{ name: "promise, for a collage 1 off", min: 0, max: 10, ticks: [0, 2, 4, 6, 8, 10] }}
        series={[
          { name: "1 / (1 − s)", colour: 1, points: STEPS.map((x) => [x, bound(1, x)] as const), nameAt: 36 },
        ]}
        now={s}
      />
      <div class={layout["controls"]}>
        <SliderControl
          label="largest copy"
          symbol="s"
          range={[0, 0.9]}
          value={s}
          text={`${fixed(s)}: ${fixed(times, 1)} times the collage`}
          onChange={setS}
        />
      </div>
    </>
  );
}
