import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { shareWords, toldOf, verdictWords } from "#format/verdict";
import { type Uv, uvAt } from "#geometry/path";
import { STATE } from "#geometry/states";
import { loadProof } from "#wasm/proof";
import { SliderControl } from "../../kit/frame/control";
import { Formula } from "../../kit/frame/formula";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { drawn, preset, studioHref } from "../../kit/frame/studio-link";
import { Chip, VerdictChip } from "../../kit/frame/verdict";
import { Square } from "../../kit/locus/locus-square";
import { useChart } from "../../kit/locus/morph-locus";
import { breakage, stretchWords } from "../../kit/maps/breakage";
import { boxAround, framesAlong, mapsAt, STRAIGHT } from "../../kit/maps/morphs";
import { tex } from "../../kit/notation/tex";
import { Drawn } from "../../kit/picture/annotated";
import { Picture } from "../../kit/picture/picture";
import stillsCss from "../../kit/picture/stills.module.css";
import { number, point } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { useStates, useVerdict } from "../../kit/workers";
import { Guess } from "../frame/choices";
import { Lesson, Question, Truth } from "../frame/lesson";
import lessonCss from "../frame/lesson.module.css";
import { nearWords, type Prediction, usePrediction } from "../frame/prediction";
import { Exercises } from "./exercises";
import { Coordinate, ends, FROM, judge, SAMPLES, SIZE, TO } from "./leading";
import { TEACHING } from "./teaching";

const STILLS = 10;
/** So near to it is right. */
const CLOSE = 0.015;

/** What must be there before it is shown. */
export const needs = [loadProof];

/** Straight against drawn path. */
export function Page(heading: Heading) {
  const prediction = usePrediction<number>(0, number(0, 1, 2));
  const [way, setWay] = useKept<Uv>("way", [0.5, 0.5], point(-1, 2));
  const t = prediction.guess ?? 0;
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            One dragon becomes another. Each has three maps; each map turns and stretches by{" "}
            <Formula>u</Formula> and moves by <Formula>v</Formula>, both from 0 to 1. On the straight way they
            go in step. Both ends are in one piece. Nobody has promised that of the shapes between.
          </p>
          <p>
            But turning and moving need not go in step. Every pair (u, v) is a shape, so all pairs together
            make a map of shapes, and a morph is a way across that map, from A to B. First guess where the
            straight way breaks; then lead it yourself.
          </p>
        </>
      }
      question={<Breaking prediction={prediction} way={way} onWay={setWay} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        { name: "First shape", symbol: "A", value: "Heighway’s dragon, written with three maps" },
        { name: "Last shape", symbol: "B", value: "the terdragon" },
        { name: "Moment you chose", symbol: "t", value: fixed(t) },
        { name: "Waypoint", symbol: tex`(u, v)`, value: [tex`(${fixed(way[0])}, ${fixed(way[1])})`] },
        { name: "Resolution of the verdicts", symbol: "ε", value: "1/600 of the shape" },
        { name: "Moments judged on a path", value: String(SAMPLES) },
      ]}
      sources={
        <p>
          The two parameters and the map of shapes, the <em>connectedness locus</em>, are Burch and Hart’s
          (1997): <a href="#figures/5">Figures 5</a>, <a href="#figures/6">6</a> and{" "}
          <a href="#figures/7">7</a> show theirs. This pair, and the widest gap as a measure of a path, are
          Frond’s.
        </p>
      }
      studio={{
        href: studioHref({
          a: preset(FROM),
          b: preset(TO),
          t,
          path: prediction.shown ? drawn([[0, 0], way, [1, 1]]) : { kind: "straight", points: [] },
        }),
      }}
    >
      <Stills />
    </Lesson>
  );
}

/** The straight morph in a few stills, without verdicts. */
function Stills() {
  const frames = useMemo(() => framesAlong(ends(), STRAIGHT, STILLS), []);
  const box = useMemo(() => boxAround(frames.map((frame) => frame.maps)), [frames]);
  return (
    <ol class={stillsCss["stills"]} aria-label="The straight morph" style={{ "--frames": String(STILLS) }}>
      {frames.map(({ t, maps }) => (
        <li key={t}>
          <Picture
            maps={maps}
            box={box}
            margin={0.03}
            label={`The shape at t = ${fixed(t)} of the straight way`}
          />
          <span class={`${stillsCss["still-mark"]} number`} aria-hidden="true">
            {fixed(t)}
          </span>
        </li>
      ))}
    </ol>
  );
}

interface BreakingProps {
  prediction: Prediction<number>;
  way: Uv;
  onWay: (way: Uv) => void;
}

function Breaking({ prediction, way, onWay }: BreakingProps) {
  const t = prediction.guess ?? 0;
  const maps = useMemo(() => mapsAt(ends(), [t, t]), [t]);
  const box = useMemo(() => boxAround(framesAlong(ends(), STRAIGHT, STILLS).map((f) => f.maps)), []);
  const path = useMemo(() => ({ ...ends(), options: {}, points: STRAIGHT }), []);
  const states = useStates(path);
  const broken = useMemo(() => (states ? breakage(states) : null), [states]);
  const first = broken?.stretches[0]?.t0 ?? null;
  return (
    <Question
      prediction={prediction}
      truth={first}
      within={CLOSE}
      beside={<Picture maps={maps} box={box} label={`The shape at t = ${fixed(t)} of the straight way.`} />}
      answer={
        broken && (
          <Truth
            line={`You said t = ${fixed(t)}. It first breaks at ${fixed(first ?? 0)}. ${nearWords(t, first ?? 0, { close: CLOSE, fair: 0.06 })}`}
          >
            <p>
              On the straight way the shape is broken for t = {stretchWords(broken.stretches)}. By the time
              the pieces have turned far enough to let go of each other, they have not yet moved to where they
              would meet again.
            </p>
          </Truth>
        )
      }
      after={<Leading way={way} onWay={onWay} />}
    >
      <Guess
        ask="The straight way from dragon to terdragon. Drag to the moment at which you think it first falls apart."
        label="Moment"
        symbol="t"
        min={0}
        max={1}
        step={0.01}
        format={(value) => fixed(value)}
        prediction={prediction}
        truth={first}
      />
    </Question>
  );
}

/** The map of shapes, with one waypoint to lead the morph by. */
function Leading({ way, onWay }: { way: Uv; onWay: (way: Uv) => void }) {
  const wish = useMemo(() => ({ ends: ends(), options: {}, size: SIZE }), []);
  const field = useChart(wish);
  const points = useMemo((): Uv[] => [[0, 0], way, [1, 1]], [way]);
  const check = useMemo(() => judge(points), [points]);
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <Square
        field={field}
        label={`The map of shapes with the path from A over (${fixed(way[0])}, ${fixed(way[1])}) to B. Light: in one piece.`}
        lines={[
          { name: "straight", points: STRAIGHT, dashed: true },
          { name: "led", points },
        ]}
        point={way}
        onMove={onWay}
      />
      <div class={lessonCss["ask"]}>
        <p>
          This is the map of shapes: where it is light the shape is in one piece, and the darker, the wider
          the gap. Now lead the morph. Drag the ring, or the two sliders, until the solid line stays in the
          light; the dashed one is the straight way. How good a way is, its <em>widest gap</em> tells: the
          widest that opens anywhere on it.
        </p>
        <div aria-live="polite">
          <Chip
            tone={check.holds ? "close" : "broken"}
            text={check.holds ? verdictWords(toldOf(STATE.touching, 0)).text : "In pieces"}
            aside={check.holds ? "at each moment judged" : `widest gap ${shareWords(check.gap)}`}
          />
        </div>
        <Coordinate name="u" about="turn and stretch" value={way[0]} onChange={(u) => onWay([u, way[1]])} />
        <Coordinate name="v" about="move" value={way[1]} onChange={(v) => onWay([way[0], v])} />
        <Halfway points={points} />
      </div>
    </div>
  );
}

/** A look at the led morph. */
function Halfway({ points }: { points: readonly Uv[] }) {
  const [t, setT] = useKept("moment", 0.5, number(0, 1, 2));
  const maps = useMemo(() => mapsAt(ends(), uvAt(points, t)), [points, t]);
  const box = useMemo(() => boxAround([maps]), [maps]);
  const judged = useVerdict(maps);
  return (
    <>
      <Drawn form="flat" maps={maps} box={box} label={`The shape at t = ${fixed(t)} of your way.`} />
      <VerdictChip answer={judged?.answer ?? null} stale={judged?.maps !== maps} />
      <SliderControl label="moment on your way" symbol="t" step={0.01} value={t} onChange={setT} />
    </>
  );
}
