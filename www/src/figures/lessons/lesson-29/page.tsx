import { fixed } from "#format/numbers";
import layout from "../../kit/frame/layout.module.css";
import { studioHref } from "../../kit/frame/studio-link";
import { tex } from "../../kit/notation/tex";
import { number } from "../../kit/state/fields";
import {
  ChoiceQuestion,
  Formula,
  type Heading,
  Lesson,
  type Prediction,
  useChoice,
  useKept,
} from "../frame/parts";
import { Curve } from "../lesson-18/curve";
import { mapsOf } from "../lesson-18/rough";
import { Copies } from "./copies";
import { Exercises } from "./exercises";
import { MOST, SMOOTH, tent } from "./hill";
import { TEACHING } from "./teaching";

type What = "teeth" | "hill" | "flat";
const OPTIONS = [
  {
    value: "teeth",
    label: "Small teeth all over it, as with any s above 0",
    wrong: "So it is with nearly every s: try 0.15 and 0.35 below. But one s is another matter.",
  },
  { value: "hill", label: "A smooth hill without a single corner" },
  {
    value: "flat",
    label: "A tent still, a little bulged, with its corner in the middle",
    wrong: "With an s between 0 and ¼ the middle keeps a corner. Look at 0.24, and then at 0.25.",
  },
] as const;

/** One number leads from a tent to a parabola, and on to a curve without a slope. */
export function Page(heading: Heading) {
  const prediction = useChoice<What>(OPTIONS);
  const [s, setS] = useKept("s", 0.5, number(0, MOST, 2));
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            Three points: on the ground, 1 high, on the ground again. Two straight lines join them to a tent.
            Now let each half carry a copy of the whole, half as wide and <Formula>s</Formula> times as tall,
            and let the copies carry copies, without end. The three points stay where they are.
          </p>
          <p>
            So the curve is its own recipe: on the left half <Formula tex={tex`f(x) = s \, f(2x) + 2x`} />,
            and the same from the right. Slide <Formula>s</Formula>. At ½ it looks like a cloud, and beyond
            like a mountain range.
          </p>
        </>
      }
      question={<Quarter prediction={prediction} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        { name: "Points", value: "at x = 0, ½ and 1: heights 0, 1 and 0" },
        {
          name: "Maps",
          value: [
            tex`f_1(x, y) = \left(\tfrac{x}{2},\; x + s y\right)`,
            tex`f_2(x, y) = \left(\tfrac{x + 1}{2},\; 1 - x + s y\right)`,
          ],
        },
        { name: "Height of the copies", symbol: "s", value: `0 to ${MOST}` },
        { name: "Drawn", value: "at 1024 even steps; there the heights are exact but for rounding" },
      ]}
      sources={
        <p>
          Curves through given points that are made so are Michael Barnsley’s (
          <cite>Fractal functions and interpolation</cite>, 1986). That tents a quarter as tall fill a
          parabola stands in Archimedes’ <cite>Quadrature of the Parabola</cite>; the curve of ½ is Teiji
          Takagi’s (1903), which is continuous and has no finite slope anywhere. Georg Landsberg took other{" "}
          <Formula>s</Formula> (1908). The dimension is that of <a href="#learn/e18">How rough is a curve?</a>
        </p>
      }
      studio={{
        href: studioHref({
          a: { name: "Parabola", maps: mapsOf(tent(SMOOTH)) },
          b: { name: `Copies ${fixed(s)} as tall`, maps: mapsOf(tent(s)) },
        }),
      }}
    >
      <Curve
        large
        curve={tent(s)}
        label={`A curve over three points, each half of which carries a copy of it ${fixed(s)} times as tall.`}
      />
      <div class={layout["controls"]}>
        <Copies value={s} onChange={setS} />
      </div>
    </Lesson>
  );
}

function Quarter({ prediction }: { prediction: Prediction<What> }) {
  const [s, setS] = useKept("asked", SMOOTH, number(0, MOST, 2));
  return (
    <ChoiceQuestion<What>
      prediction={prediction}
      ask="With s = 0 it is the tent, with two straight sides. With s = ½ it is rough all over. What is it with s = ¼?"
      options={OPTIONS}
      truth="hill"
      after={
        <div class={`${layout["two-columns"]} ${layout["even"]}`}>
          <Curve curve={tent(s)} label={`The curve whose copies are ${fixed(s)} times as tall.`} />
          <Copies value={s} onChange={setS} />
        </div>
      }
      line="A smooth hill: it is the parabola 4x(1 − x), exactly."
    >
      <p>
        Put the parabola <Formula tex={tex`p(x) = 4x(1 - x)`} /> into the recipe. A quarter of{" "}
        <Formula tex={tex`p(2x) = 8x(1 - 2x)`} /> is <Formula tex={tex`2x - 4x^2`} />, and with{" "}
        <Formula tex={tex`2x`} /> that is <Formula tex={tex`4x - 4x^2`} />: the parabola again. There is only
        one curve that keeps the recipe, so this is it.
      </p>
      <p>
        Each step adds tents that are a quarter as tall as those before. That rounds off the corners that are
        there just so much that none is left in the end. A little more or a little less, and there are corners
        wherever one looks. To be made of copies of itself is not the same as to be rough.
      </p>
    </ChoiceQuestion>
  );
}
