import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { reasonWords } from "#format/reason";
import { Segmented } from "#ui/controls/Segmented";
import { loadProof, prover } from "#wasm/proof";
import { Plot } from "../../kit/chart/plot";
import { barnsley, type Round } from "../../kit/connectedness/barnsley";
import { Rows } from "../../kit/connectedness/barnsley-rows";
import { Formula } from "../../kit/frame/formula";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { studioHref } from "../../kit/frame/studio-link";
import { Chip } from "../../kit/frame/verdict";
import { dust } from "../../kit/maps/families";
import { tex } from "../../kit/notation/tex";
import { oneOf, whole } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Guess } from "../frame/choices";
import { Lesson, Question, Truth } from "../frame/lesson";
import lessonCss from "../frame/lesson.module.css";
import { nearWords, type Prediction, usePrediction } from "../frame/prediction";
import { Exercises } from "./exercises";
import { TEACHING } from "./teaching";

/** The dust of the finished picture, and the one that is asked about. */
const [SHOWN, ASKED] = [0.45, 0.49];
const MOST_ROUNDS = 11;
const SCALES = [
  { value: "0.49", label: "r = 0.49" },
  { value: "0.499", label: "r = 0.499" },
  { value: "0.5", label: "r = ½" },
] as const;
type Scale = (typeof SCALES)[number]["value"];

/** What must be there before it is shown. */
export const needs = [loadProof];

/** Barnsley's bound closing in. */
export function Page(heading: Heading) {
  const prediction = usePrediction<number>(2, whole(0, MOST_ROUNDS - 1));
  const rounds = useMemo(() => barnsley(SHOWN, MOST_ROUNDS), []);
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            Two maps shrink a line by <Formula>r</Formula>, one towards 0 and one towards 1. Are the two
            pieces apart? No computer can look at all of their points. So let a few points stand for each:
            step <Formula>n</Formula> has <Formula tex={tex`2^n`} /> of them, and no part of a piece is
            farther from its own than the bars reach, <Formula tex={tex`r^{n+1}`} />.
          </p>
          <p>
            Measure the least distance <Formula>d</Formula> between points of different colours. As long as it
            is below <Formula tex={tex`2 r^{n+1}`} />, the bars overlap and nothing is known. Once it is
            above, no point of one piece can be in the other: they are <em>proved</em> apart. For{" "}
            <Formula tex={tex`r = ${SHOWN}`} /> this takes until{" "}
            <Formula tex={tex`n = ${rounds.at(-1)?.n ?? 0}`} />.
          </p>
        </>
      }
      question={<When prediction={prediction} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        { name: "Maps", value: [tex`f_1(x) = r x`, tex`f_2(x) = r x + 1 - r`] },
        { name: "Scale in the picture above", symbol: "r", value: String(SHOWN) },
        { name: "Scale in the question", symbol: "r", value: String(ASKED) },
        { name: "Radius that holds the shape", symbol: "R", value: "1, about the origin" },
        { name: "Bound, here with s = r", value: [tex`2 s^{n+1} R`] },
      ]}
      sources={
        <p>
          The test is Michael Barnsley’s (<cite>Fractals Everywhere</cite>, 1988), as Burch and Hart print it
          in their Figure 1; the example is Frond’s. <a href="#figures/1">Figure 1</a> has it step by step.
        </p>
      }
      studio={{
        href: studioHref({
          a: { name: "Dust at ½", maps: dust(0.5) },
          b: { name: "Dust at 0.45", maps: dust(SHOWN) },
          t: (0.5 - ASKED) / (0.5 - SHOWN),
        }),
      }}
    >
      <div class={layout["two-columns"]}>
        <Rows rounds={rounds} r={SHOWN} />
        <Closing rounds={rounds} r={SHOWN} to={4} />
      </div>
    </Lesson>
  );
}

interface ClosingProps {
  rounds: readonly Round[];
  r: number;
  marks?: { at: number; name: string; guess?: boolean }[];
  /** How far the axis goes. */
  to?: number;
  height?: number;
}

/** The distance and the bound, by step. */
function Closing({ rounds, r, marks = [], to = MOST_ROUNDS - 1, height = 216 }: ClosingProps) {
  const last = rounds.at(-1);
  return (
    <Plot
      label={`At r = ${r} the least distance falls from ${fixed(rounds[0]?.distance ?? 0, 3)} to ${fixed(last?.distance ?? 0, 4)} and the bound to ${fixed(last?.bound ?? 0, 4)} at n = ${last?.n ?? 0}: ${last?.apart ? "proved apart" : "nothing proved"}.`}
      x={{ name: "n", min: 0, max: to, ticks: [0, 2, 4, 6, 8, 10].filter((tick) => tick <= to) }}
      y={{
        name: "distance",
        min: to > 4 ? 3e-4 : 0.08,
        max: 1,
        log: true,
        ticks: to > 4 ? [0.001, 0.01, 0.1, 1] : [0.1, 0.2, 0.5, 1],
        format: (value) => String(value),
      }}
      height={height}
      marks={marks}
      series={[
        {
          name: "2rⁿ⁺¹",
          points: rounds.map((round) => [round.n, round.bound]),
          colour: 5,
          dashed: true,
          dots: true,
          nameAt: 1,
          raise: 10,
        },
        {
          name: "d",
          points: rounds.map((round) => [round.n, round.distance]),
          colour: 1,
          dots: true,
          nameAt: 1,
          raise: -18,
        },
      ]}
    />
  );
}

function When({ prediction }: { prediction: Prediction<number> }) {
  const { shown } = prediction;
  const guess = prediction.guess ?? 2;
  const all = useMemo(() => barnsley(ASKED, MOST_ROUNDS), []);
  const truth = all.at(-1)?.n ?? 0;
  const marks = [
    ...(prediction.said ? [{ at: guess, name: `your guess, ${guess}`, guess: true }] : []),
    ...(shown ? [{ at: truth, name: `proved, ${truth}` }] : []),
  ];
  return (
    <Question
      prediction={prediction}
      truth={truth}
      beside={<Closing rounds={shown ? all : all.slice(0, 2)} r={ASKED} marks={marks} height={330} />}
      answer={
        <Truth
          line={`You said n = ${guess}. It is proved at n = ${truth}. ${nearWords(guess, truth, { close: 0, fair: 1 })}`}
        >
          <p>
            The bound falls to about half with each step, without end. The distance falls too, but only to the
            gap itself, which is <Formula tex={tex`1 - 2r = ${fixed(1 - 2 * ASKED)}`} />. So the bound must
            get below it at last. The narrower the gap, the longer it takes.
          </p>
        </Truth>
      }
      after={<Never />}
    >
      <Guess
        ask={`Now r = ${ASKED}. The pieces are nearer to each other: the gap is only a fiftieth. At which n will they be proved apart?`}
        undrawn
        label="Step"
        symbol="n"
        min={0}
        max={MOST_ROUNDS - 1}
        step={1}
        format={(value) => fixed(value, 0)}
        prediction={prediction}
        truth={truth}
      />
    </Question>
  );
}

/** The same at other scales, and at the one where it never ends. */
function Never() {
  const [scale, setScale] = useKept<Scale>("scale", "0.5", oneOf(SCALES.map(({ value }) => value)));
  const r = Number(scale);
  const rounds = useMemo(() => barnsley(r, MOST_ROUNDS), [r]);
  const apart = rounds.at(-1)?.apart === true;
  const proof = useMemo(() => prover().connectedness({ maps: dust(0.5) }, { epsilon: 1e-6 }).reason, []);
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <Closing rounds={rounds} r={r} />
      <div class={lessonCss["ask"]}>
        <Segmented label="Scale r" options={SCALES} value={scale} onChange={setScale} />
        <Chip
          tone={apart ? "broken" : "unknown"}
          text={apart ? "In pieces" : "Nothing proved"}
          aside={
            apart
              ? `by the bounds of the test, at n = ${rounds.at(-1)?.n}`
              : `after ${MOST_ROUNDS} steps, nor ever`
          }
        />
        <p>
          At ½ the pieces meet, and the two curves fall side by side for ever. The test can only say “apart”
          or nothing; it can never say “together”. Its silence after a thousand steps may mean that the pieces
          touch, or that the gap is too narrow yet. To prove that something is in one piece takes a reason of
          another kind.{proof && ` Here is Frond’s for ½: ${reasonWords(proof.text)}`}
        </p>
      </div>
    </div>
  );
}
