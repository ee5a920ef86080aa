import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { verdictPhrase } from "#format/verdict";
import { Plot } from "../../kit/chart/plot";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { studioHref } from "../../kit/frame/studio-link";
import { EXACT, VerdictChip } from "../../kit/frame/verdict";
import { mapsOf } from "../../kit/locus/set-m";
import { boxAround } from "../../kit/maps/morphs";
import { tex } from "../../kit/notation/tex";
import { Picture } from "../../kit/picture/picture";
import { number } from "../../kit/state/fields";
import { useVerdict } from "../../kit/workers";
import lessonCss from "../frame/lesson.module.css";
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
import { onCircle } from "../lesson-25/walk";
import { Exercises } from "./exercises";
import { dustDimension, PLANE } from "./size";
import { TEACHING } from "./teaching";

const ANGLE = 88;
const [LOWEST, HIGHEST] = [0.5, 0.9];
/** So near to it is right. */
const CLOSE = 0.011;

/** Why M has an inner circle and an outer one. */
export function Page(heading: Heading) {
  const prediction = usePrediction<number>(LOWEST, number(LOWEST, HIGHEST, 2));
  const [size, setSize] = useKept("size", 0.55, number(0.3, 0.74, 2));
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            A shape of two pieces of size <Formula tex={tex`\lvert s \rvert`} /> is in one piece or dust. If
            it is dust, its pieces are apart, and then Moran’s equation tells its dimension:{" "}
            <Formula tex={tex`2 \, \lvert s \rvert^D = 1`} />. It asks for nothing but the size.
          </p>
          <p>
            Change the size, and watch the number grow. It is true only as long as the shape is dust. When it
            is in one piece, the equation still gives a number, but the pieces overlap or touch, and it need
            not be the dimension any more.
          </p>
        </>
      }
      question={<TooLarge prediction={prediction} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        { name: "Maps", value: [tex`f_1(z) = s z - 1`, tex`f_2(z) = s z + 1`] },
        { name: "Angle of s", value: `${ANGLE}°` },
        { name: "Dimension of a dust", symbol: "D", value: [tex`\frac{\log 2}{-\log \lvert s \rvert}`] },
        { name: "Verdict", symbol: "ε", value: [tex`10^{-6}`, " of the size"] },
      ]}
      sources={
        <p>
          Patrick Moran (1946) proved the equation for pieces that are apart. That the shape is in one piece
          from <Formula tex={tex`\lvert s \rvert = 1 / \sqrt{2}`} /> on, and dust below ½, stands in Michael
          Barnsley and Andrew Harrington’s paper on M (1985).
        </p>
      }
      studio={{
        href: studioHref({
          a: { name: `Size ${fixed(size)}`, maps: mapsOf(onCircle(size, ANGLE)) },
          b: { name: "Twin-dragon", maps: mapsOf([0.5, 0.5]) },
        }),
      }}
    >
      <Sized size={size} onSize={setSize} />
    </Lesson>
  );
}

interface SizedProps {
  size: number;
  onSize: (size: number) => void;
}

function Sized({ size, onSize }: SizedProps) {
  const maps = useMemo(() => mapsOf(onCircle(size, ANGLE)), [size]);
  const box = useMemo(() => boxAround([maps]), [maps]);
  const judged = useVerdict(maps, EXACT);
  const answer = judged?.maps === maps ? judged.answer : null;
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <Picture
        maps={maps}
        box={box}
        label={`The shape of size ${fixed(size)} and angle ${ANGLE} degrees: ${verdictPhrase(answer, EXACT)}.`}
      />
      <div class={lessonCss["ask"]}>
        <SliderControl
          label="size of"
          symbol="s"
          name="Size of s"
          range={[0.3, 0.74]}
          step={0.01}
          value={size}
          onChange={(next) => onSize(Number(next.toFixed(2)))}
        />
        <VerdictChip epsilon={EXACT} answer={judged?.answer ?? null} stale={judged?.maps !== maps} />
        <p class="number" aria-live="polite">
          Moran’s equation gives {fixed(dustDimension(size))}
          {answer?.verdict === "disconnected" ? ", and that is the dimension of this dust." : "."}
        </p>
      </div>
    </div>
  );
}

const SIZES = Array.from({ length: 46 }, (_, i) => 0.3 + i * 0.01);

function TooLarge({ prediction }: { prediction: Prediction<number> }) {
  const guess = prediction.guess ?? LOWEST;
  return (
    <Question
      prediction={prediction}
      truth={PLANE}
      within={CLOSE}
      beside={
        <Plot
          label="The dimension that a dust of two pieces would have, by their size: 1 at one half, and growing."
          x={{ name: "|s|", min: 0.3, max: 0.75, ticks: [0.3, 0.4, 0.5, 0.6, 0.7] }}
          y={{ name: "dimension of a dust", min: 0.5, max: 2.5, ticks: [0.5, 1, 1.5, 2, 2.5] }}
          height={300}
          series={[
            {
              name: "D",
              colour: 1,
              points: SIZES.map((at) => [at, dustDimension(at)] as const),
              nameAt: 30,
            },
          ]}
          now={Math.min(0.75, guess)}
        />
      }
      answer={
        <Truth
          line={`You said ${fixed(guess)}. From 0.7071, the root of ½, on. ${nearWords(guess, PLANE, { close: CLOSE, fair: 0.04 })}`}
        >
          <p>
            There a dust would have dimension 2, and beyond it more. But it lies in the plane, in which
            nothing has more than dimension 2. So beyond 0.7071 it cannot be dust: its pieces must meet. At
            0.7071 itself they meet, too; there one has to argue with areas.
          </p>
          <p>
            On the other side it is the same with a line: below ½ the shape has a dimension below 1. What is
            in one piece, and more than a point, has at least dimension 1. So it is dust. These are the two
            circles around M. Between them size alone does not tell.
          </p>
        </Truth>
      }
    >
      <Guess
        ask="A shape in the plane has at most dimension 2. From which size of s on can the shape no longer be dust, whatever its angle?"
        label="Size of s"
        symbol="s"
        min={LOWEST}
        max={HIGHEST}
        step={0.01}
        format={(value) => fixed(value)}
        prediction={prediction}
        truth={PLANE}
      />
    </Question>
  );
}
