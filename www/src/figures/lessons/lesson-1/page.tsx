import { useMemo, useState } from "preact/hooks";
import type { Box } from "#document/framing";
import { fixed } from "#format/numbers";
import { lengthWords } from "#format/verdict";
import { SliderControl } from "../../kit/frame/control";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { studioHref } from "../../kit/frame/studio-link";
import { EXACT, VerdictChip, Why } from "../../kit/frame/verdict";
import { gasket, HEIGHT } from "../../kit/maps/families";
import { tex } from "../../kit/notation/tex";
import { Drawn, Span } from "../../kit/picture/annotated";
import annotatedCss from "../../kit/picture/annotated.module.css";
import { Picture } from "../../kit/picture/picture";
import { useVerdict } from "../../kit/workers";
import { Guess } from "../frame/choices";
import { Lesson, Question, Truth } from "../frame/lesson";
import { nearWords, usePrediction } from "../frame/prediction";
import css from "./page.module.css";

const WHOLE: Box = { x0: 0, y0: 0, x1: 1, y1: HEIGHT };
/** Where pieces 1 and 2 meet. */
const MEET = 0.5;
const [LOWEST, HIGHEST] = [0.4, 0.56];

/** What touching means. */
export function Page(heading: Heading) {
  const prediction = usePrediction<number>(HIGHEST);
  const r = prediction.guess ?? HIGHEST;
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            This triangle is made of three copies of itself, each half as large: piece 1 at the lower left,
            piece 2 at the lower right, piece 3 on top. Every piece is made of three smaller ones in turn, and
            so on without end.
          </p>
          <p>
            Two pieces <em>touch</em> if some point belongs to both. One is enough. Near is not: however small
            a gap is, a stronger lens would show it. Here the lens finds none, at any strength, because the
            tip of piece 1 and the tip of piece 2 are the same point.
          </p>
        </>
      }
      question={<Parting prediction={prediction} r={r} />}
      parameters={[
        {
          name: "Maps, towards the corners of a triangle of side 1",

          value: [tex`f_i(x) = r x + (1 - r)\, c_i`],
        },
        { name: "Scale in the picture above", symbol: "r", value: "½" },
        { name: "Scale you chose", symbol: "r", value: fixed(r, 3) },
      ]}
      sources={
        <p>
          That a shape of this kind is in one piece exactly when its pieces hang together by touching is a
          theorem of Masayoshi Hata (1985). Burch and Hart use this family of triangles for their Table 1.
        </p>
      }
      studio={{
        href: studioHref({
          a: { name: "Gasket, maps at 0.4", maps: gasket(LOWEST) },
          b: { name: "Gasket, maps at 0.56", maps: gasket(HIGHEST) },
          t: (r - LOWEST) / (HIGHEST - LOWEST),
        }),
      }}
    >
      <Meeting />
    </Lesson>
  );
}

/** The gasket, and its meeting point through a lens. */
function Meeting() {
  const [power, setPower] = useState(6);
  const maps = useMemo(() => gasket(0.5), []);
  const half = 0.7 * 2 ** -power;
  const lens = useMemo<Box>(() => lensAt(half), [half]);
  const times = Math.round(2 ** power);
  return (
    <>
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Panel caption="The ring marks where pieces 1 and 2 meet.">
          <Drawn
            maps={maps}
            box={WHOLE}
            label="Sierpinski’s gasket: three half-size copies of itself, each touching both others in a corner."
          >
            {(place) => {
              const [x, y] = place([MEET, 0]);
              return <circle class={annotatedCss["lens"]} cx={x} cy={y} r={9} />;
            }}
          </Drawn>
        </Panel>
        <Panel
          caption={
            <span class="number">The same place, {times === 1 ? "as it is" : `${times} times larger`}</span>
          }
        >
          <Picture
            maps={maps}
            box={lens}
            margin={0}
            label={`The meeting point ${times} times larger: two tips that share a point.`}
          />
        </Panel>
      </div>
      <div class={layout["controls"]}>
        <SliderControl
          label="Strength of the lens"
          range={[0, 16]}
          step={1}
          value={power}
          text={`${times} ×`}
          valueText={`${times} times`}
          onChange={setPower}
        />
      </div>
    </>
  );
}

function lensAt(half: number): Box {
  return { x0: MEET - half, x1: MEET + half, y0: -0.35 * half, y1: 1.15 * half };
}

interface PartingProps {
  prediction: ReturnType<typeof usePrediction<number>>;
  r: number;
}

function Parting({ prediction, r }: PartingProps) {
  const maps = useMemo(() => gasket(r), [r]);
  const gap = 1 - 2 * r;
  return (
    <Question
      prediction={prediction}
      beside={<Picture maps={maps} box={WHOLE} label={`The triangle with pieces of scale ${fixed(r, 3)}.`} />}
      answer={
        <Truth
          line={`You said ${fixed(r, 3)}. They part below 0.500. ${nearWords(r, 0.5, { close: 0.0025, fair: 0.012 })}`}
        >
          <p>
            Along the bottom edge piece 1 reaches from 0 to r, and piece 2 from 1 − r to 1. They share a point
            as long as r is at least 1 − r, which is to say ½.{" "}
            {gap > 1e-9
              ? `At your ${fixed(r, 3)} there is a gap of 1 − 2r = ${lengthWords(gap)} of the side, whether or not the eye finds it.`
              : gap < -1e-9
                ? `At your ${fixed(r, 3)} they do not only touch but overlap, by ${lengthWords(-gap)} of the side.`
                : "At exactly ½ they touch in a single point."}
          </p>
        </Truth>
      }
      after={<Closer r={r} gap={gap} />}
    >
      <Guess
        ask="Now let every piece shrink towards its own corner. Drag to where you think they just part."
        label="Scale of the pieces"
        symbol="r"
        min={LOWEST}
        max={HIGHEST}
        step={0.001}
        format={(value) => fixed(value, 3)}
        prediction={prediction}
        truth={0.5}
      />
    </Question>
  );
}

/** The guess through a lens that is strong enough to show what is between the pieces. */
function Closer({ r, gap }: { r: number; gap: number }) {
  const maps = useMemo(() => gasket(r), [r]);
  const judged = useVerdict(maps, 1e-6);
  const half = Math.min(0.5, Math.max(2e-3, 2 * Math.abs(gap)));
  const box = useMemo(() => lensAt(half), [half]);
  return (
    <figure class={`${layout["panel"]} ${css["closer"]}`}>
      <Drawn
        maps={maps}
        box={box}
        margin={0}
        label={`Your scale, ${Math.round(0.5 / half)} times larger: ${gap > 0 ? `a gap of ${lengthWords(gap)}` : "no gap"}.`}
      >
        {(place) =>
          gap > 1e-9 && (
            <Span from={place([r, 0])} to={place([1 - r, 0])} name={lengthWords(gap)} kind="below strong" />
          )
        }
      </Drawn>
      <figcaption>
        <span>Your scale through the lens, {Math.round(0.5 / half)} times larger.</span>
        <VerdictChip epsilon={EXACT} answer={judged?.answer ?? null} stale={judged?.maps !== maps} />
        <Why answer={judged?.answer} />
      </figcaption>
    </figure>
  );
}
