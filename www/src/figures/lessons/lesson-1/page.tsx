import { useMemo } from "preact/hooks";
import type { Box } from "#document/framing";
import { fixed } from "#format/numbers";
import { lengthWords } from "#format/verdict";
import { SliderControl } from "../../kit/frame/control";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { studioHref } from "../../kit/frame/studio-link";
import { EXACT, VerdictChip, Why } from "../../kit/frame/verdict";
import { gasket, HEIGHT, unevenGasket } from "../../kit/maps/families";
import { tex } from "../../kit/notation/tex";
import { Drawn, middles, PieceNames, Span } from "../../kit/picture/annotated";
import annotatedCss from "../../kit/picture/annotated.module.css";
import { number } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { useVerdict } from "../../kit/workers";
import { Guess } from "../frame/choices";
import { Lesson, Question, Truth } from "../frame/lesson";
import { nearWords, usePrediction } from "../frame/prediction";
import { Exercises } from "./exercises";
import css from "./page.module.css";
import { TEACHING } from "./teaching";

const WHOLE: Box = { x0: 0, y0: 0, x1: 1, y1: HEIGHT };
/** Where pieces 1 and 2 meet. */
const MEET = 0.5;
/** The scales of pieces 2 and 3 in the question: they share a point, so only piece 1 may part from them. */
const [OTHER, TOP] = [0.6, 0.4];
/** Where piece 2 begins: piece 1 has to reach as far. */
const TRUTH = 1 - OTHER;
const [LOWEST, HIGHEST] = [0.25, 0.5];
/** So near to it is right. */
const CLOSE = 0.0025;
const pieces = (r: number) => unevenGasket([r, OTHER, TOP]);

/** What touching means. */
export function Page(heading: Heading) {
  const prediction = usePrediction<number>(HIGHEST, number(LOWEST, HIGHEST, 3));
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
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        {
          name: "Maps, towards the corners of a triangle of side 1",

          value: [tex`f_i(x) = r_i x + (1 - r_i)\, c_i`],
        },
        { name: "Scales in the picture above", value: "½, ½, ½" },
        { name: "Scales in the question", value: `${fixed(r, 3)}, ${fixed(OTHER)}, ${fixed(TOP)}` },
      ]}
      sources={
        <p>
          That a shape of this kind is in one piece exactly when its pieces hang together by touching is a
          theorem of Masayoshi Hata (1985). Burch and Hart use triangles of three equal pieces for their Table
          1.
        </p>
      }
      studio={{
        href: studioHref({
          a: { name: "Piece 1 at 0.25", maps: pieces(LOWEST) },
          b: { name: "Piece 1 at 0.5", maps: pieces(HIGHEST) },
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
  const [power, setPower] = useKept("lens", 0, number(0, 16, 2));
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
              return (
                <>
                  <PieceNames at={middles(maps, WHOLE).map(place)} />
                  <circle class={annotatedCss["lens"]} cx={x} cy={y} r={9} />
                </>
              );
            }}
          </Drawn>
        </Panel>
        <Panel
          caption={
            <span class="number">The same place, {times === 1 ? "as it is" : `${times} times larger`}</span>
          }
        >
          <Drawn
            maps={maps}
            box={lens}
            margin={0}
            label={`The meeting point ${times} times larger: two tips that share a point.`}
          >
            {(place, unit) => {
              // As wide as a quarter of the picture, in a round number.
              const length = 10 ** Math.floor(Math.log10(130 / unit));
              const [x, y] = place([lens.x0, lens.y0]);
              return (
                <Span
                  from={[x + 12, y - 22]}
                  to={[x + 12 + length * unit, y - 22]}
                  name={lengthWords(length)}
                  kind="below"
                />
              );
            }}
          </Drawn>
        </Panel>
      </div>
      <div class={layout["controls"]}>
        <SliderControl
          label="Strength of the lens"
          range={[0, 16]}
          step={0.05}
          value={power}
          text={`${times} ×`}
          valueText={`${times} times`}
          onChange={setPower}
        />
      </div>
    </>
  );
}

function lensAt(half: number, at = MEET): Box {
  return { x0: at - half, x1: at + half, y0: -0.35 * half, y1: 1.15 * half };
}

interface PartingProps {
  prediction: ReturnType<typeof usePrediction<number>>;
  r: number;
}

function Parting({ prediction, r }: PartingProps) {
  const maps = useMemo(() => pieces(r), [r]);
  const gap = TRUTH - r;
  return (
    <Question
      prediction={prediction}
      truth={TRUTH}
      within={CLOSE}
      beside={
        <Drawn
          maps={maps}
          box={WHOLE}
          label={`A triangle of three unlike pieces: piece 1 at the lower left has scale ${fixed(r, 3)}.`}
        >
          {(place) => <PieceNames at={middles(maps, WHOLE).map(place)} />}
        </Drawn>
      }
      answer={
        <Truth
          line={`You said ${fixed(r, 3)}. They part below ${fixed(TRUTH, 3)}. ${nearWords(r, TRUTH, { close: CLOSE, fair: 0.012 })}`}
        >
          <p>
            Along the bottom edge piece 1 reaches from 0 to its scale r. Piece 2 is {fixed(OTHER)} wide, so it
            begins at {fixed(TRUTH)}. They share a point as long as r is at least that.{" "}
            {gap > 1e-9
              ? `At your ${fixed(r, 3)} there is a gap of ${lengthWords(gap)} of the side, whether or not the eye finds it.`
              : gap < -1e-9
                ? `At your ${fixed(r, 3)} they do not only touch but overlap, by ${lengthWords(-gap)} of the side.`
                : `At exactly ${fixed(TRUTH)} they touch in a single point.`}
          </p>
        </Truth>
      }
      after={<Closer r={r} gap={gap} />}
    >
      <Guess
        ask="Piece 2 is larger now, 0.6 of the whole. Let piece 1 shrink into its corner: how small may it get before the two part?"
        label="Scale of piece 1"
        symbol="r"
        min={LOWEST}
        max={HIGHEST}
        step={0.001}
        format={(value) => fixed(value, 3)}
        prediction={prediction}
        truth={TRUTH}
      />
    </Question>
  );
}

/** The guess through a lens that is strong enough to show what is between the pieces. */
function Closer({ r, gap }: { r: number; gap: number }) {
  const maps = useMemo(() => pieces(r), [r]);
  const judged = useVerdict(maps, 1e-6);
  const half = Math.min(0.4, Math.max(2e-3, 2 * Math.abs(gap)));
  const box = useMemo(() => lensAt(half, (r + TRUTH) / 2), [half, r]);
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
            <Span from={place([r, 0])} to={place([TRUTH, 0])} name={lengthWords(gap)} kind="below strong" />
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
