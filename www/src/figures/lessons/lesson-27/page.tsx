import { useMemo } from "preact/hooks";
import type { Box } from "#document/framing";
import { fixed } from "#format/numbers";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { tex } from "../../kit/notation/tex";
import { Picture } from "../../kit/picture/picture";
import { whole } from "../../kit/state/fields";
import {
  Formula,
  Guess,
  type Heading,
  Lesson,
  nearWords,
  type Prediction,
  Question,
  Truth,
  useKept,
  usePrediction,
} from "../frame/parts";
import { Exercises } from "./exercises";
import { fewestFor, LEAF, MOST_DIGITS, NEAR, promise, rounded } from "./rounded";
import { TEACHING } from "./teaching";

const BOX: Box = { x0: -0.65, x1: 0.65, y0: -0.05, y1: 1.1 };
const NUMBERS = 6 * LEAF.length;

/** A leaf as the digits of its maps. */
export function Page(heading: Heading) {
  const prediction = usePrediction<number>(1, whole(1, MOST_DIGITS));
  const [digits, setDigits] = useKept("digits", 1, whole(1, MOST_DIGITS));
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            Four copies cover this leaf, and so four maps make it. Each map is six numbers: {NUMBERS} numbers
            are the whole leaf, with all of its lobes, and the lobes of these, without end. A picture of it,
            300 points wide and high, is 90,000 points, and shows no more than points.
          </p>
          <p>
            But how long is a number? Write each with few digits after the point, and they are slightly
            different maps. These make a leaf as well, a different one. How different?
          </p>
        </>
      }
      question={<HowMany prediction={prediction} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        { name: "Leaf", value: "the four copies of “Cover the leaf” that its hints lead to" },
        { name: "Numbers", value: `${LEAF.length} maps of 6` },
        { name: "Promise", value: [tex`\frac{\max_i \sup_x \lvert f_i(x) - g_i(x) \rvert}{1 - s}`] },
      ]}
      sources={
        <p>
          That a shape depends on its maps without jumps stands in Michael Barnsley’s{" "}
          <cite>Fractals Everywhere</cite> (1988), and so does the idea to keep pictures as maps. The promise
          follows as that of his collage theorem does, which <a href="#learn/e23">Cover the leaf</a> tells.
        </p>
      }
      studio={{
        href: studioHref({
          a: { name: `Leaf of ${digits} digits`, maps: rounded(LEAF, digits) },
          b: preset("maple"),
        }),
      }}
    >
      <Both digits={digits} onDigits={setDigits} />
    </Lesson>
  );
}

interface BothProps {
  digits: number;
  onDigits: (digits: number) => void;
}

/** The leaf, and the leaf of rounded maps. */
function Both({ digits, onDigits }: BothProps) {
  const maps = useMemo(() => rounded(LEAF, digits), [digits]);
  const leaf = useMemo(() => [...LEAF], []);
  return (
    <>
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Panel caption="the leaf, with all digits">
          <Picture maps={leaf} box={BOX} label="A leaf of four copies of itself." />
        </Panel>
        <Panel
          caption={`${digits} digit${digits === 1 ? "" : "s"} after the point: ${NUMBERS * digits} digits in all`}
        >
          <Picture
            maps={maps}
            box={BOX}
            label={`The leaf that is made by maps with ${digits} digits after the point.`}
          />
        </Panel>
      </div>
      <div class={layout["controls"]}>
        <Digits value={digits} onChange={onDigits} />
      </div>
      <p class="number">First map: {(maps[0] ?? []).map((x) => fixed(x, digits)).join(", ")}</p>
    </>
  );
}

export function Digits({ value, onChange }: { value: number; onChange: (digits: number) => void }) {
  return (
    <SliderControl
      label="digits after the point"
      range={[1, MOST_DIGITS]}
      whole
      value={value}
      onChange={onChange}
    />
  );
}

/** A promise is kept by what is rounded up alone. */
const roundedUp = (x: number, digits: number) => Math.ceil(x * 10 ** digits) / 10 ** digits;

function HowMany({ prediction }: { prediction: Prediction<number> }) {
  const truth = fewestFor(NEAR);
  const guess = prediction.guess ?? 1;
  const maps = useMemo(() => rounded(LEAF, guess), [guess]);
  return (
    <Question
      prediction={prediction}
      truth={truth}
      beside={
        <Picture
          maps={maps}
          box={BOX}
          label={`The leaf that is made by maps with ${guess} digits after the point.`}
        />
      }
      answer={
        <Truth
          line={`You said ${guess}. With ${truth} digits it is surely within ${fixed(roundedUp(promise(LEAF, rounded(LEAF, truth)), 4), 4)}. ${nearWords(guess, truth, { close: 0, fair: 1 })}`}
        >
          <p>
            Rounding moves what a map makes of a point by some small distance <Formula>c</Formula> at most. In
            the leaf this is repeated in every copy of a copy, but made smaller each time, by{" "}
            <Formula>s</Formula> at most: <Formula tex={tex`c + cs + cs^2 + \dots = c / (1 - s)`} />. With{" "}
            {truth - 1} digits this promise is {fixed(promise(LEAF, rounded(LEAF, truth - 1)), 3)} of the
            height, more than a hundredth.
          </p>
          <p>
            So {NUMBERS * truth} digits are a leaf that is nowhere farther from the exact one than a sixth of
            a point, in a picture 100 points high. A promise is the worst case: with fewer digits one may be
            lucky.
          </p>
        </Truth>
      }
    >
      <Guess
        ask="How many digits after the point does each number need, so that the leaf is surely within a hundredth of its height, wherever one looks?"
        label="Digits"
        min={1}
        max={MOST_DIGITS}
        step={1}
        format={(value) => fixed(value, 0)}
        prediction={prediction}
        truth={truth}
      />
    </Question>
  );
}
