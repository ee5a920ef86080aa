import { useMemo } from "preact/hooks";
import type { Box } from "#document/framing";
import { lengthWords } from "#format/verdict";
import type { MapRow } from "#wasm/api";
import { type Edge, groups } from "../../kit/connectedness/collisions";
import { Graph } from "../../kit/connectedness/overlap-graph";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { cutKoch, PEAK } from "../../kit/maps/families";
import { apply, type Point } from "../../kit/maps/pieces";
import { tex } from "../../kit/notation/tex";
import { Drawn, PieceNames, Span } from "../../kit/picture/annotated";
import { list, oneOf } from "../../kit/state/fields";
import { useVerdict } from "../../kit/workers";
import choicesCss from "../frame/choices.module.css";
import { Lesson, Question, Truth } from "../frame/lesson";
import { type Prediction, usePrediction } from "../frame/prediction";
import { Exercises } from "./exercises";
import css from "./page.module.css";
import { TEACHING } from "./teaching";

type Pair = readonly [i: number, j: number];

const CUT = 0.06;
const COUNT = 4;
const BOX: Box = { x0: 0, y0: -0.02, x1: 1, y1: 0.38 };
const EPSILON = 1e-6;
const PAIRS: readonly Pair[] = [
  [0, 1],
  [0, 2],
  [0, 3],
  [1, 2],
  [1, 3],
  [2, 3],
];
/** The pieces from left to right round the ring of the graph. */
const ANGLES = [Math.PI * 0.9, Math.PI * 0.65, Math.PI * 0.35, Math.PI * 0.1];
/** The numbers stand on the outer side of the pieces. */
const NAMED: Point = [0.5, 0.46];

const key = ([i, j]: Pair) => `${i}-${j}`;
const pairName = ([i, j]: Pair) => `${i + 1} and ${j + 1}`;
const touches = (found: readonly Pair[], pair: Pair) => found.some((one) => key(one) === key(pair));
const edge = ([i, j]: Pair): Edge => ({ between: [i, j], at: 0, pixel: 0 });

/** The overlap graph. */
export function Page(heading: Heading) {
  const prediction = usePrediction<readonly string[]>(null, list(oneOf(PAIRS.map(key)), 0, PAIRS.length));
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            Koch’s curve is made of four copies of itself. To see whether it is in one piece, draw a dot for
            each copy, and a line between two dots if those copies touch. This is the <em>overlap graph</em>.
            Here it is a chain: 1 touches 2, 2 touches 3, 3 touches 4.
          </p>
          <p>
            If one can walk along lines from every dot to every other, the shape is in one piece; if not, it
            is in several. Nothing smaller need be looked at. Each copy is made exactly like the whole, so
            what holds for the four holds within each of them as well.
          </p>
        </>
      }
      question={<Edges prediction={prediction} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        { name: "Maps above", value: "four of scale ⅓: Koch’s curve" },
        { name: "Maps below", value: "the same, the sides of the peak turned outward" },
        { name: "Width of the cut at the peak", value: String(CUT) },
        { name: "Verdict", symbol: "ε", value: [tex`10^{-6}`, " of the size"] },
      ]}
      sources={
        <p>
          Masayoshi Hata proved in 1985 that such a shape is in one piece exactly when its overlap graph is.
          It is Theorem 2 of Burch and Hart. Helge von Koch drew the curve in 1904.
        </p>
      }
      studio={{
        href: studioHref({ a: preset("koch"), b: { name: "Koch curve, cut", maps: cutKoch(CUT) }, t: 1 }),
      }}
    >
      <Chain />
    </Lesson>
  );
}

function Chain() {
  const maps = useMemo(() => cutKoch(0), []);
  return (
    <div class={layout["two-columns"]}>
      <Pieces maps={maps} label="Koch’s curve and its four copies, numbered from left to right." />
      <Graph count={COUNT} angles={ANGLES} still edges={[edge([0, 1]), edge([1, 2]), edge([2, 3])]} />
    </div>
  );
}

function Pieces({ maps, label, gap = false }: { maps: MapRow[]; label: string; gap?: boolean }) {
  return (
    <Drawn maps={maps} box={BOX} form="flat" label={label}>
      {(place) => (
        <>
          <PieceNames at={maps.map((map) => place(apply(map, NAMED)))} />
          {gap && (
            <Span
              from={place([(1 - CUT) / 2, PEAK])}
              to={place([(1 + CUT) / 2, PEAK])}
              name={lengthWords(CUT)}
              kind="strong"
            />
          )}
        </>
      )}
    </Drawn>
  );
}

function Edges({ prediction }: { prediction: Prediction<readonly string[]> }) {
  const maps = useMemo(() => cutKoch(CUT), []);
  const judged = useVerdict(maps, EPSILON);
  const found = judged?.answer.overlaps ?? [];
  const { guess, shown } = prediction;
  const drawn = PAIRS.filter((pair) => guess?.includes(key(pair)));
  const yours = groups(COUNT, drawn).count;
  return (
    <Question
      prediction={prediction}
      truth={judged && PAIRS.filter((pair) => touches(found, pair)).map(pairName)}
      beside={
        <>
          <Pieces
            maps={maps}
            gap={shown}
            label="A curve like Koch’s whose peak is cut open: pieces 2 and 3 do not meet on top."
          />
          <Graph count={COUNT} angles={ANGLES} still edges={shown ? found.map(edge) : []} expected={drawn} />
          <p class={`${layout["hint"]} ${css["graph-key"]}`}>
            {shown ? "Solid: these touch. Dotted: your lines." : "Dotted: your lines."}
          </p>
        </>
      }
      answer={judged && <Answer found={found} drawn={drawn} count={judged.answer.count} />}
    >
      <fieldset class={choicesCss["choices"]}>
        <legend>
          Somebody has cut the peak open. Which pieces touch now? And is the curve still in one piece?
        </legend>
        <div class={css["pairs"]}>
          {PAIRS.map((pair) => (
            <EdgeChoice
              key={key(pair)}
              pair={pair}
              prediction={prediction}
              truth={shown ? touches(found, pair) : null}
            />
          ))}
        </div>
      </fieldset>
      <p class={layout["hint"]} aria-live="polite">
        {guess === null
          ? "Tick the pairs that you think touch."
          : `You drew ${count(drawn.length, "line")}. With ${drawn.length === 1 ? "it" : "them"} the curve would be in ${yours === 1 ? "one piece" : `${yours} groups`}.`}
      </p>
    </Question>
  );
}

interface EdgeChoiceProps {
  pair: Pair;
  prediction: Prediction<readonly string[]>;
  /** Whether these two do touch; null while it is covered. */
  truth: boolean | null;
}

function EdgeChoice({ pair, prediction, truth }: EdgeChoiceProps) {
  const { guess, say } = prediction;
  const name = key(pair);
  const ticked = guess?.includes(name) ?? false;
  return (
    <label class={`${choicesCss["option"]} ${truth ? choicesCss["so"] : ""}`}>
      <input
        type="checkbox"
        checked={ticked}
        disabled={truth !== null}
        onChange={() => say(ticked ? (guess ?? []).filter((one) => one !== name) : [...(guess ?? []), name])}
      />
      <span>{pairName(pair)}</span>
      {truth !== null && <span class={choicesCss["option-mark"]}>{truth ? "touch" : "apart"}</span>}
    </label>
  );
}

interface AnswerProps {
  found: readonly Pair[];
  drawn: readonly Pair[];
  count: number;
}

function Answer({ found, drawn, count: pieces }: AnswerProps) {
  const has = (list: readonly Pair[], pair: Pair) => list.some((one) => key(one) === key(pair));
  const missed = found.filter((pair) => !has(drawn, pair));
  const extra = drawn.filter((pair) => !has(found, pair));
  return (
    <Truth
      line={`${words(found)} touch: ${pieces === 1 ? "the curve is in one piece" : `${pieces} groups, so the curve is in pieces`}.`}
    >
      <p>
        {missed.length + extra.length === 0 && "Your graph is the same. "}
        {missed.length > 0 && `You left out ${words(missed)}. `}
        {extra.length > 0 && `You joined ${words(extra)}, which are apart. `}
        No line leads from the left half of the graph to the right one, and that settles it. Every small copy
        has the same cut, so there are not two parts but infinitely many; yet four dots were enough to see it.
      </p>
    </Truth>
  );
}

/** "1 and 2, 3 and 4" */
function words(pairs: readonly Pair[]): string {
  return pairs.map(([i, j]) => `${i + 1} and ${j + 1}`).join(", ") || "No two";
}

function count(number: number, noun: string): string {
  return number === 0 ? `no ${noun}s` : number === 1 ? `one ${noun}` : `${number} ${noun}s`;
}
