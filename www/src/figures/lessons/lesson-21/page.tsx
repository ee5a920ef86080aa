import { useMemo } from "preact/hooks";
import { verdictPhrase } from "#format/verdict";
import { SliderControl } from "../../kit/frame/control";
import { Formula } from "../../kit/frame/formula";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { EXACT, VerdictChip, Why } from "../../kit/frame/verdict";
import { mapsOf } from "../../kit/locus/set-m";
import { boxAround, mapsAt } from "../../kit/maps/morphs";
import { tex } from "../../kit/notation/tex";
import { Picture } from "../../kit/picture/picture";
import { oneOf } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { useVerdict } from "../../kit/workers";
import { type Choice, Choices, Reply } from "../frame/choices";
import { Lesson, Question, Truth } from "../frame/lesson";
import { type Prediction, usePrediction } from "../frame/prediction";
import { APART_S, CURVE, type Curve } from "./curves";
import { Exercises } from "./exercises";
import { Ends, Square, words } from "./square";
import { TEACHING } from "./teaching";

type Guess = "meet" | "apart";
const TRUTH: Guess = "apart";

/** Why crossing proves touching, and what it takes. */
export function Page(heading: Heading) {
  const prediction = usePrediction<Guess>(null, oneOf(["meet", "apart"]));
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            Two curves in a square, each from one place of its border to another. Go once round the square: if
            the ends take turns, A, B, A, B, the curves have a point in common. Nothing that they do on the
            way helps them. Drag the ends of B, and swing the curves, and try to part them.
          </p>
          <p>
            That is a proof, and no picture: it needs no look at the place where they meet, and it stays true
            when both are moved a little. It follows from <em>Jordan’s curve theorem</em>: a closed curve that
            does not cross itself has an inside and an outside.
          </p>
        </>
      }
      question={<Apart prediction={prediction} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        { name: "The two pieces", value: [tex`s z - 1`, tex`s z + 1`, tex`s = 0.0227 + 0.703 i`] },
        { name: "The three pieces", value: ["dragon to gasket, ", tex`u = 0.5`, tex`v = 1.75`] },
        { name: "Resolution of the verdicts", symbol: "ε", value: [tex`10^{-6}`, " of the shape"] },
      ]}
      sources={
        <>
          <p>
            Camille Jordan stated the curve theorem in 1887; Oswald Veblen gave the proof of 1905 that is
            taken for the first complete one. The <em>trap</em> is Danny Calegari, Sarah Koch and Alden
            Walker’s (arXiv 1410.8542), for two maps; Frond’s form of it, for any number of affine maps, is
            proved in full on the page <a href="./theorems.html#crossings">What the proofs rest on</a>.
          </p>
          <p>That pieces which hang together make a shape in one piece is Masayoshi Hata’s theorem (1985).</p>
        </>
      }
      studio={{ href: studioHref({ a: preset("dragon-3"), b: preset("gasket"), t: 0.5 }) }}
    >
      <Play />
    </Lesson>
  );
}

function Play() {
  const [a, setA] = useKept<Curve>("a", { from: 3.5, to: 1.5, swing: 0.25 }, CURVE);
  const [b, setB] = useKept<Curve>("b", { from: 0.35, to: 2.4, swing: -0.2 }, CURVE);
  return (
    <>
      <Square a={a} b={b} onB={setB} />
      <p aria-live="polite">{words(a, b)}</p>
      <Ends b={b} onB={setB} />
      <div class={layout["controls"]}>
        <Swing name="A" curve={a} onCurve={setA} />
        <Swing name="B" curve={b} onCurve={setB} />
      </div>
    </>
  );
}

function Swing({ name, curve, onCurve }: { name: string; curve: Curve; onCurve: (curve: Curve) => void }) {
  return (
    <SliderControl
      label={`swing of ${name}`}
      range={[-0.6, 0.6]}
      step={0.05}
      value={curve.swing}
      onChange={(swing) => onCurve({ ...curve, swing })}
    />
  );
}

const OPTIONS: readonly Choice<Guess>[] = [
  {
    value: "meet",
    label: "Yes, they meet",
    wrong: "In the picture it looks so. But nothing in it is finer than a pixel, and the gap is.",
  },
  { value: "apart", label: "No, they do not" },
];

function Apart({ prediction }: { prediction: Prediction<Guess> }) {
  const maps = useMemo(() => mapsOf(APART_S), []);
  const box = useMemo(() => boxAround([maps]), [maps]);
  const judged = useVerdict(maps, EXACT);
  return (
    <Question
      prediction={prediction}
      truth={TRUTH}
      beside={
        <Panel>
          <Picture
            maps={maps}
            box={box}
            label="A shape of two pieces that seem to lie right against each other"
          />
          {/* Its room is kept, so that nothing moves when it comes. */}
          <div style={{ visibility: prediction.shown ? "visible" : "hidden" }}>
            <VerdictChip epsilon={EXACT} answer={judged?.answer ?? null} />
          </div>
        </Panel>
      }
      answer={
        <Truth
          line={`They do not meet: it is ${judged ? verdictPhrase(judged.answer, EXACT) : "in pieces"}.`}
        >
          <Reply options={OPTIONS} prediction={prediction} truth={TRUTH} />
          <p>
            A piece is no curve. It may have gaps itself, and the other piece may go through them. So near is
            not touching, and that two pieces lie across each other is no proof yet.
          </p>
          <p>
            The <em>trap</em> makes it one. Suppose that the shape is in pieces, and that <Formula>g</Formula>{" "}
            is its widest gap. A piece is the whole made smaller, so the gaps in it are narrower than{" "}
            <Formula>g</Formula>: thicken it by half of such a gap, and it hangs together like a curve. If two
            pieces, thickened so, have ends that jut out far enough and take turns, they must meet. So the
            pieces are nearer to each other than <Formula>g</Formula>. If such pairs link all pieces, every
            gap is narrower than the widest: impossible. So there is no gap.
          </p>
        </Truth>
      }
      after={<Crossing />}
    >
      <Choices<Guess>
        ask="Here are two pieces of a shape, one in each colour. Do they have a point in common?"
        options={OPTIONS}
        prediction={prediction}
        truth={TRUTH}
      />
    </Question>
  );
}

/** A shape that the trap proves to be in one piece. */
function Crossing() {
  const maps = useMemo(
    () => mapsAt({ from: preset("dragon-3").maps, to: preset("gasket").maps }, [0.5, 1.75]),
    [],
  );
  const box = useMemo(() => boxAround([maps]), [maps]);
  const judged = useVerdict(maps, EXACT);
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <Panel>
        <Picture maps={maps} box={box} label="Three pieces that lie across each other" />
      </Panel>
      <div>
        <p>Here the trap closes. This is what Frond says of these three pieces:</p>
        <VerdictChip epsilon={EXACT} answer={judged?.answer ?? null} />
        <Why answer={judged?.answer} />
        <p class={layout["hint"]}>
          A machine found the ends by calculation with bounds for its rounding. In the studio such a proof can
          be saved, for a checker of its own that replays it in whole numbers.
        </p>
      </div>
    </div>
  );
}
