import { fixed } from "#format/numbers";
import { Plot } from "../../kit/chart/plot";
import { SliderControl } from "../../kit/frame/control";
import { Formula } from "../../kit/frame/formula";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { studioHref } from "../../kit/frame/studio-link";
import { tex } from "../../kit/notation/tex";
import { list, number } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { ChoiceQuestion } from "../frame/choice-question";
import { Lesson } from "../frame/lesson";
import lessonCss from "../frame/lesson.module.css";
import { type Prediction, useChoice } from "../frame/prediction";
import { Curve } from "./curve";
import { Half, Sparing } from "./exercises";
import { climb, dimension, isStraight, mapsOf, samples } from "./rough";
import { TEACHING } from "./teaching";

const HEIGHTS = [0, 0.7, 0.3, 0.9, 0.2];
const POINTS = list(number(0, 1), HEIGHTS.length, HEIGHTS.length);
/** The largest factor that is offered: at 1 nothing would shrink any more. */
const MOST = 0.8;
const even = (heights: readonly number[], s: number) => ({ heights, factors: [s, s, s, s] });
type Start = "any" | "quarter" | "half" | "never";

/** Fractal functions, and what makes them rough. */
export function Page(heading: Heading) {
  const prediction = useChoice<Start>(OPTIONS);
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            Five points, joined by four straight lines. Now replace each line by a flattened copy of the whole
            zigzag, and each line of that again, without end. What comes out is a curve that goes through all
            five points and is rough everywhere, like a coast or a mountain.
          </p>
          <p>
            How tall the copies are is told by one number, the roughness <Formula>s</Formula>: each copy is{" "}
            <Formula>s</Formula> times as tall as the whole, and a quarter as wide. Slide it, and drag the
            points up and down.
          </p>
        </>
      }
      question={<When prediction={prediction} />}
      exercises={
        <>
          <Half heights={HEIGHTS} />
          <Sparing heights={HEIGHTS} />
        </>
      }
      teaching={TEACHING}
      parameters={[
        { name: "Points", value: "at x = 0, ¼, ½, ¾ and 1" },
        {
          name: "Map of piece i, from 1 to 4",
          value: [tex`x \to \frac{x + i - 1}{4}`, ", ", tex`y \to c_i x + s_i y + d_i`],
        },
        { name: "Its slope and shift", value: "such that the ends of the whole go to the ends of the piece" },
        { name: "Roughness", symbol: "s", value: `the same for all four above, 0 to ${MOST}` },
        { name: "Drawn", value: "at 1024 even steps; there the heights are exact but for rounding" },
      ]}
      sources={
        <p>
          Such curves through given points are Michael Barnsley’s (1986). Their dimension by boxes was found
          by Douglas Hardin and Peter Massopust (1986). For N pieces of the same width it is{" "}
          <Formula tex={tex`1 + \frac{\log(|s_1| + \dots + |s_N|)}{\log N}`} /> if the sum is above 1 and the
          points are not on one line; else it is 1.
        </p>
      }
      studio={{
        href: studioHref({
          a: { name: "Rough curve", maps: mapsOf(even(HEIGHTS, 0.2)) },
          b: { name: "Rougher curve", maps: mapsOf(even(HEIGHTS, 0.6)) },
        }),
      }}
    >
      <Play />
    </Lesson>
  );
}

function Roughness({ value, onChange }: { value: number; onChange: (s: number) => void }) {
  return (
    <SliderControl
      label="roughness"
      symbol="s"
      range={[0, MOST]}
      step={0.01}
      value={value}
      onChange={(next) => onChange(Number(next.toFixed(2)))}
    />
  );
}

function Play() {
  const [heights, setHeights] = useKept<readonly number[]>("heights", HEIGHTS, POINTS);
  const [s, setS] = useKept("roughness", 0.35, number(0, MOST, 2));
  return (
    <>
      <Curve
        large
        curve={even(heights, s)}
        label={`A curve through five points with roughness ${fixed(s)}. The points can be moved up and down.`}
        onMove={setHeights}
      />
      <div class={layout["controls"]}>
        <Roughness value={s} onChange={setS} />
      </div>
    </>
  );
}

const OPTIONS = [
  {
    value: "any",
    label: "At once: any roughness above 0 makes it more than a line",
    wrong:
      "It does look jagged at once. But look at s = 0.1 below: the ups and downs that each step adds shrink so fast that all of them together stay bounded.",
  },
  { value: "quarter", label: "At ¼, where the four roughnesses sum to 1" },
  {
    value: "half",
    label: "At ½, where each copy is half as tall as the whole",
    wrong: "At ½ it is well beyond: look below how the ups and downs double with each step there.",
  },
  {
    value: "never",
    label: "Never: it is a curve, and a curve has dimension 1",
    wrong:
      "A smooth curve has. But try s = 0.6 below: the ups and downs grow without bound, and so it takes more boxes than any smooth curve.",
  },
] as const;

function When({ prediction }: { prediction: Prediction<Start> }) {
  const [s, setS] = useKept("asked", 0.1, number(0, MOST, 2));
  const curve = even(HEIGHTS, s);
  return (
    <ChoiceQuestion<Start>
      prediction={prediction}
      ask="A line has dimension 1. As the roughness goes up from 0, when does the dimension of the curve begin to be more than 1?"
      options={OPTIONS}
      truth="quarter"
      beside={
        <>
          <Curve curve={curve} label={`The curve with roughness ${fixed(s)}.`} />
          <Roughness value={s} onChange={setS} />
        </>
      }
      after={<Explore />}
      line="Beyond ¼. There the four roughnesses sum to 1, and with more the dimension is more than 1."
    >
      <p>
        Look at the ups and downs, all added together. Each step puts four copies in place of the whole, each{" "}
        <Formula>s</Formula> times as tall: from step to step what is added is <Formula tex={tex`4s`} /> times
        as much. Below 1 that dies away, and the curve has a length, like a line. Above 1 it grows without
        bound.
      </p>
      <p>
        Boxes a quarter as wide fit the copies as the old ones fitted the whole, only that the copies are{" "}
        <Formula tex={tex`4s`} /> times as tall for them. So there are four times as many columns, each with
        about <Formula tex={tex`4s`} /> times as many boxes. Hence the dimension:{" "}
        <Formula tex={tex`1 + \frac{\log 4s}{\log 4}`} />. At ½ it is 1.5, half-way between a line and an
        area.
      </p>
    </ChoiceQuestion>
  );
}

const LEVELS = [1, 2, 3, 4, 5, 6];
const GRID = Array.from({ length: 41 }, (_, i) => i / 50);

/** The curve, how its ups and downs grow, and its dimension. */
function Explore() {
  const [heights, setHeights] = useKept<readonly number[]>("measured", HEIGHTS, POINTS);
  const [s, setS] = useKept("measure", 0.5, number(0, MOST, 2));
  const curve = even(heights, s);
  const climbs = LEVELS.map((level) => climb(samples(curve, level)));
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <div class={lessonCss["ask"]}>
        <Curve
          curve={curve}
          label={`The curve with roughness ${fixed(s)}. Its points can be moved up and down.`}
          onMove={setHeights}
        />
        <Roughness value={s} onChange={setS} />
        <p class="number">
          The four roughnesses sum to {fixed(4 * s)}. Dimension {fixed(dimension(curve), 3)}
          {isStraight(heights) ? ": all points are on one line, and so is the curve." : "."}
        </p>
      </div>
      <div>
        <Plot
          label={`All ups and downs together, in ever smaller steps: ${climbs.map((sum) => fixed(sum)).join(", ")}.`}
          x={{
            min: 4,
            max: 4096,
            log: true,
            ticks: LEVELS.map((level) => 4 ** level),
            format: String,
            name: "steps across",
          }}
          y={{
            min: 0.1,
            max: 1000,
            log: true,
            ticks: [0.1, 1, 10, 100, 1000],
            format: String,
            name: "ups and downs",
          }}
          series={[
            {
              name: "",
              colour: 1,
              dots: true,
              points: climbs.map((sum, i): [number, number] => [4 ** (i + 1), sum]),
            },
          ]}
        />
        <Plot
          label={`The dimension against the roughness: 1 up to one quarter, then more; ${fixed(dimension(curve), 3)} at ${fixed(s)}.`}
          height={180}
          x={{ min: 0, max: MOST, ticks: [0, 0.25, 0.5, 0.75], name: "roughness s" }}
          y={{ min: 1, max: 2, ticks: [1, 1.5, 2], name: "dimension" }}
          series={[
            {
              name: "",
              colour: 2,
              points: GRID.map((at): [number, number] => [at, dimension(even(heights, at))]),
            },
          ]}
          now={s}
        />
      </div>
    </div>
  );
}
