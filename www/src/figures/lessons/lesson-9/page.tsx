import { useMemo } from "preact/hooks";
import type { Box } from "#document/framing";
import { fixed } from "#format/numbers";
import { lengthWords, shareOf, shareWords } from "#format/verdict";
import type { MapRow } from "#wasm/api";
import { SliderControl } from "../../kit/frame/control";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { studioHref } from "../../kit/frame/studio-link";
import { EXACT, VerdictChip } from "../../kit/frame/verdict";
import { mapsOf } from "../../kit/locus/set-m";
import { HEIGHT, unevenGasket } from "../../kit/maps/families";
import { boxAround } from "../../kit/maps/morphs";
import { type Apart, distances, spanningTree } from "../../kit/maps/pieces";
import { tex } from "../../kit/notation/tex";
import { Drawn, middles, PieceNames, type Place, Span } from "../../kit/picture/annotated";
import { type Field, list, number, oneOf } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { useVerdict } from "../../kit/workers";
import { type Choice, Choices, Reply } from "../frame/choices";
import { Lesson, Question, Truth } from "../frame/lesson";
import lessonCss from "../frame/lesson.module.css";
import { type Prediction, usePrediction } from "../frame/prediction";
import { Exercises } from "./exercises";
import { TEACHING } from "./teaching";

/** Scales of the three pieces: two that meet and one alone, and three apart by three different gaps. */
const ALONE = [0.5, 0.5, 0.3] as const;
const THREE = [0.52, 0.42, 0.28] as const;
const WHOLE: Box = { x0: 0, y0: 0, x1: 1, y1: HEIGHT };
type Scales = readonly [number, number, number];
const SCALES = list(number(0.2, 0.6, 2), 3, 3) as Field<Scales>;
type Gap = "least" | "tree" | "widest" | "sum";

/** Why three pieces differ from two. */
export function Page(heading: Heading) {
  const prediction = usePrediction<Gap>(null, oneOf(["least", "tree", "widest", "sum"]));
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            With two pieces there is one question: do they meet? If they do, the shape is in one piece. If
            not, it is dust. So one distance tells everything.
          </p>
          <p>
            With three pieces there are three distances. Two pieces may meet while the third stands alone: the
            least distance is then 0, and the shape is still in pieces. What counts is the <em>gap</em>: the
            widest step that cannot be avoided when one walks over all the pieces.
          </p>
        </>
      }
      question={<Widest prediction={prediction} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        {
          name: "Two pieces",
          value: [tex`f_1(z) = s z - 1`, tex`f_2(z) = s z + 1`, tex`s = \tfrac12 + \tfrac12 i`],
        },
        { name: "Three pieces", value: "towards the corners of a triangle of side 1" },
        { name: "Their scales above", value: ALONE.map((r) => fixed(r)).join(", ") },
        { name: "Their scales in the question", value: THREE.map((r) => fixed(r)).join(", ") },
        { name: "Distances", value: ["by splitting pairs of pieces, to ", tex`10^{-4}`] },
      ]}
      sources={
        <p>
          To measure a shape, and a morph, by the widest edge of the shortest tree between its pieces is
          Frond’s. That it is 0 exactly when the shape is in one piece follows from Hata’s theorem (1985).
        </p>
      }
      studio={{
        href: studioHref({
          a: { name: "Three apart", maps: unevenGasket(THREE) },
          b: { name: "Two and one", maps: unevenGasket(ALONE) },
        }),
      }}
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <TwoPieces />
        <Alone />
      </div>
    </Lesson>
  );
}

function TwoPieces() {
  const maps = useMemo(() => mapsOf([0.5, 0.5]), []);
  const box = useMemo(() => boxAround([maps]), [maps]);
  return <Judged maps={maps} box={box} words="Two pieces: they meet, and that is all there is to know." />;
}

function Alone() {
  const maps = useMemo(() => unevenGasket(ALONE), []);
  return <Judged maps={maps} box={WHOLE} words="Three pieces: 1 meets 2, and 3 stands alone." />;
}

function Judged({ maps, box, words }: { maps: MapRow[]; box: Box; words: string }) {
  const judged = useVerdict(maps, EXACT);
  return (
    <Panel
      caption={
        <>
          <span>{words}</span>
          <VerdictChip epsilon={EXACT} answer={judged?.answer ?? null} />
        </>
      }
    >
      <Drawn maps={maps} box={box} label={words}>
        {(place) => <PieceNames at={middles(maps, box).map(place)} />}
      </Drawn>
    </Panel>
  );
}

function Widest({ prediction }: { prediction: Prediction<Gap> }) {
  const { shown } = prediction;
  const maps = useMemo(() => unevenGasket(THREE), []);
  const all = useMemo(() => distances(maps), [maps]);
  const { edges, widest } = useMemo(() => spanningTree(3, all), [all]);
  const judged = useVerdict(maps, EXACT);
  const sorted = all.map((pair) => pair.upper).sort((p, q) => p - q);
  const [least = 0, , most = 0] = sorted;
  const tree = widest?.upper ?? 0;
  const found = judged?.answer;
  const options: readonly Choice<Gap>[] = [
    {
      value: "least",
      label: `${fixed(least)}, the least of the three`,
      wrong: `With steps of ${fixed(least)} you come from 1 to 2, but never to 3.`,
    },
    { value: "tree", label: `${fixed(tree)}, the one in the middle` },
    {
      value: "widest",
      label: `${fixed(most)}, the widest of the three`,
      wrong: `From 2 to 3 it is ${fixed(most)}. But whoever stands on 1 has a shorter step to 3.`,
    },
    {
      value: "sum",
      label: `${fixed(least + tree)}, the two shorter ones together`,
      wrong: "You take one step after the other: the widest of them counts, and not how far you go in all.",
    },
  ];
  return (
    <Question
      prediction={prediction}
      truth="tree"
      beside={<Measured maps={maps} all={all} tree={shown ? edges : null} />}
      answer={
        <Truth
          line={`The gap is ${fixed(tree)}${found === undefined ? "" : `; Frond’s verdict says ${lengthWords(found.gap.upper)}, ${shareWords(shareOf(found))} of the diameter`}.`}
        >
          <Reply options={options} prediction={prediction} truth="tree" />
          <p>
            From 1 to 2 it is {fixed(least)}. From there to 3 the nearer way is {fixed(tree)}, from piece 1.
            These two steps are a tree that reaches all pieces, so nobody need take the step of {fixed(most)},
            drawn dashed. The widest step of the shortest tree is the gap. It is 0 exactly when the shape is
            in one piece, and it changes without jumps as the maps do: that is why Frond can draw it as a map,
            and lead morphs by it.
          </p>
        </Truth>
      }
      after={<Explore />}
    >
      <Choices<Gap>
        ask="Here are three pieces and their distances. You may step from piece to piece as you like, and want to reach all. How wide is the widest step that you cannot avoid?"
        options={options}
        prediction={prediction}
        truth="tree"
      />
    </Question>
  );
}

interface MeasuredProps {
  maps: MapRow[];
  all: readonly Apart[];
  /** The edges of the shortest tree, the widest last; null while they are not told. */
  tree: readonly Apart[] | null;
}

/** Three pieces with what is between them. */
function Measured({ maps, all, tree }: MeasuredProps) {
  const kind = (pair: Apart) =>
    tree === null ? "" : pair === tree.at(-1) ? "strong" : tree.includes(pair) ? "" : "light";
  return (
    <Drawn
      maps={maps}
      box={WHOLE}
      label={`Three pieces. ${all.map(({ between: [i, j], upper }) => `${i + 1} and ${j + 1} are ${fixed(upper)} apart`).join(", ")}.`}
    >
      {(place) => (
        <>
          <PieceNames at={middles(maps, WHOLE).map(place)} />
          {all.map((pair) => (
            <Distance key={pair.between.join()} pair={pair} place={place} kind={kind(pair)} />
          ))}
        </>
      )}
    </Drawn>
  );
}

/** The same three with scales to play with. */
function Explore() {
  const [scales, setScales] = useKept<Scales>("scales", THREE, SCALES);
  const maps = useMemo(() => unevenGasket(scales), [scales]);
  const all = useMemo(() => distances(maps, 1e-3), [maps]);
  const { edges } = useMemo(() => spanningTree(3, all), [all]);
  const judged = useVerdict(maps, EXACT);
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <Measured maps={maps} all={all} tree={edges} />
      <div class={lessonCss["ask"]}>
        <p>Now change the pieces. Which distances matter, and which may grow without harm?</p>
        {scales.map((scale, i) => (
          <SliderControl
            key={`${i + 1}`}
            label={`scale of piece ${i + 1}`}
            range={[0.2, 0.6]}
            step={0.01}
            value={scale}
            onChange={(next) => {
              const changed: [number, number, number] = [...scales];
              changed[i] = next;
              setScales(changed);
            }}
          />
        ))}
        <VerdictChip epsilon={EXACT} answer={judged?.answer ?? null} stale={judged?.maps !== maps} />
      </div>
    </div>
  );
}

function Distance({ pair, place, kind }: { pair: Apart; place: Place; kind: string }) {
  const [from, to] = pair.closest;
  const middle = place([0.5, HEIGHT / 3]);
  return <Span from={place(from)} to={place(to)} name={fixed(pair.upper)} kind={kind} awayFrom={middle} />;
}
