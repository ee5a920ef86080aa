import { useEffect, useMemo, useState } from "preact/hooks";
import type { LocusResult } from "#compute/results";
import { fixed } from "#format/numbers";
import { OWN_BOUNDS, verdictPhrase } from "#format/verdict";
import type { Uv } from "#geometry/path";
import { Button } from "#ui/controls/Button";
import type { Connectedness } from "#wasm/api";
import { epoch, submit } from "#workers/pool/engine";
import { Formula } from "../../kit/frame/formula";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { studioHref } from "../../kit/frame/studio-link";
import { EXACT, VerdictChip, Why } from "../../kit/frame/verdict";
import { type Complex, mapsOf, quarterJob, unfolded } from "../../kit/locus/set-m";
import { boxAround } from "../../kit/maps/morphs";
import { tex } from "../../kit/notation/tex";
import { Picture } from "../../kit/picture/picture";
import { oneOf, point } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { useChannel, useValue, useVerdict } from "../../kit/workers";
import { type Choice, Choices, Reply } from "../frame/choices";
import { Lesson, Question, Truth } from "../frame/lesson";
import lessonCss from "../frame/lesson.module.css";
import { type Prediction, usePrediction } from "../frame/prediction";
import { complexWords, Disc, Sliders } from "./disc";
import { Exercises } from "./exercises";
import { TEACHING } from "./teaching";

const FIRST: Complex = [0.4, 0.5];
const SHOWN: readonly { s: Complex; text: string }[] = [
  { s: [0.5, 0.5], text: "s = 0.5 + 0.5i" },
  { s: [0.3, 0.6], text: "s = 0.3 + 0.6i" },
  { s: [0.3, 0.55], text: "s = 0.3 + 0.55i" },
];
const LANDMARKS: readonly { s: Complex; name: string; about: string }[] = [
  { s: [0.5, 0], name: "½, a line", about: "The tip of a spike: the shape is a plain line segment." },
  {
    s: [0.5, 0.5],
    name: "½ + ½i, twin-dragon",
    about: "The twin-dragon, whose two pieces meet all along a border.",
  },
  {
    s: [0.25, Math.sqrt(7) / 4],
    name: "¼ + ¼√7 i, tame twin-dragon",
    about:
      "The tame twin-dragon. Like the twin-dragon it lies on the circle of 0.7071, where two pieces have just the area of the whole.",
  },
  {
    s: [0.0227, 0.703],
    name: "0.0227 + 0.703i, dust",
    about:
      "Dust, and proved so, although |s| is 0.7034 and from 0.7071 on everything is in one piece: the edge of M runs in bays and spirals that are too fine for this map. The gap is too narrow for the picture.",
  },
];

type Which = "whole" | "dust";

/** The set M. */
export function Page(heading: Heading) {
  const prediction = usePrediction<Which>(null, oneOf(["whole", "dust"]));
  const [s, setS] = useKept<Complex>("s", FIRST, point(-1, 1, 6));
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            Take two maps that differ only by where they put things: both turn and shrink by the same complex
            number <Formula>s</Formula>, and one then moves to the left, the other to the right. One number,
            one shape. Its size <Formula tex={tex`\lvert s \rvert`} /> says how much the maps shrink, its
            angle how far they turn.
          </p>
          <p>
            A shape of two pieces has only two ways to be: the pieces meet, and it is in one piece; or they do
            not, and then their own pieces do not meet either, and so on down, until nothing is left but{" "}
            <em>dust</em>, single points. All s of the first kind make a set, called <em>M</em>.
          </p>
        </>
      }
      question={<Where prediction={prediction} s={s} onS={setS} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        { name: "Maps", value: [tex`f_1(z) = s z - 1`, tex`f_2(z) = s z + 1`] },
        { name: "The ring", symbol: "s", value: complexWords(s) },
        { name: "Its size", symbol: tex`\lvert s \rvert`, value: fixed(Math.hypot(...s), 4) },
        { name: "Verdict at s", symbol: "ε", value: [tex`10^{-6}`, " of the size"] },
        { name: "Map of M", symbol: "ε", value: [tex`10^{-4}`, " of the size"] },
      ]}
      sources={<Sources />}
      studio={{
        href: studioHref({
          a: { name: `s = ${complexWords(s)}`, maps: mapsOf(s) },
          b: { name: "Twin-dragon", maps: mapsOf([0.5, 0.5]) },
          locus: { family: "polygon", sides: 2, x: 0, y: 0, zoom: 1, w: 0, at: shortened(s) },
        }),
      }}
    >
      <div class={layout["triple"]}>
        {SHOWN.map(({ s: at, text }) => (
          <Shape key={text} s={at} text={text} />
        ))}
      </div>
    </Lesson>
  );
}

function Sources() {
  return (
    <>
      <p>
        Michael Barnsley and Andrew Harrington introduced M in 1985 by analogy with Mandelbrot’s set, which is
        also a map of what holds together. Thierry Bousch proved that M itself is in one piece.
      </p>
      <p>
        Christoph Bandt proved in 2002 that M has a hole, and conjectured that, away from the real line, M is
        the closure of its interior. Danny Calegari, Sarah Koch and Alden Walker proved this in 2017, and that
        there are infinitely many holes.
      </p>
    </>
  );
}

function Shape({ s, text }: { s: Complex; text: string }) {
  const maps = useMemo(() => mapsOf(s), [s]);
  const box = useMemo(() => boxAround([maps]), [maps]);
  const judged = useVerdict(maps, EXACT);
  return (
    <Panel
      caption={
        <>
          <span class="number">{text}</span>
          <VerdictChip epsilon={EXACT} answer={judged?.answer ?? null} />
        </>
      }
    >
      <Picture
        maps={maps}
        box={box}
        label={`The shape of ${text}: ${verdictPhrase(judged?.answer ?? null, EXACT)}.`}
      />
    </Panel>
  );
}

/** Short in a link, and still far nearer than the eye tells. */
function shortened([re, im]: Complex): Complex {
  const short = (x: number) => Math.round(x * 1e6) / 1e6;
  return [short(re), short(im)];
}

function kindOf(answer: Connectedness | undefined): Which | null {
  switch (answer?.verdict) {
    case "connected":
    case "touching":
      return "whole";
    case "disconnected":
      return "dust";
    default:
      return null;
  }
}

function foundWords(answer: Connectedness | undefined): string {
  switch (answer?.verdict) {
    case "connected":
      return `it is ${verdictPhrase(answer, EXACT)}`;
    case "touching":
      return `it ${verdictPhrase(answer, EXACT)}`;
    case "disconnected":
      return `it is dust: in pieces, ${OWN_BOUNDS}`;
    default:
      return "nobody knows";
  }
}

const OPTIONS: readonly Choice<Which>[] = [
  {
    value: "whole",
    label: "In one piece",
    wrong:
      "Its pieces come near each other, and do not meet. The ring lies in the dark: how wide is the gap?",
  },
  {
    value: "dust",
    label: "Dust",
    wrong:
      "Its pieces do meet, though it may be in a few places only. The ring lies in the light: see why below.",
  },
];

interface WhereProps {
  prediction: Prediction<Which>;
  s: Complex;
  onS: (s: Complex) => void;
}

function Where({ prediction, s, onS }: WhereProps) {
  const { shown } = prediction;
  // What was asked about: afterwards the ring may go on.
  const [asked, setAsked] = useKept<Complex>("asked", FIRST, point(-1, 1, 6));
  const at = shown ? asked : s;
  const maps = useMemo(() => mapsOf(at), [at]);
  const judged = useVerdict(maps, EXACT);
  const truth = judged?.maps === maps ? kindOf(judged.answer) : null;
  // What only looks whole makes no guess right or wrong.
  const proved = judged?.answer.verdict === "touching" ? null : truth;
  const whole = useQuarter(shown);
  const move = ([re, im]: Uv) => {
    const size = Math.hypot(re, im);
    const shrink = size > 0.74 ? 0.74 / size : 1;
    const next: Complex = [re * shrink, im * shrink];
    if (!shown) setAsked(next);
    onS(next);
  };
  return (
    <Question
      prediction={prediction}
      truth={proved}
      beside={
        <>
          <Disc field={shown ? whole : null} s={s} shown={shown} onMove={move} />
          <Sliders s={s} onMove={move} />
        </>
      }
      answer={
        truth && (
          <Truth
            line={`You said ${prediction.guess === "whole" ? "one piece" : "dust"}. At s = ${complexWords(asked)} ${foundWords(judged?.answer)}.`}
          >
            {proved === null ? (
              <p>
                {prediction.guess === "whole"
                  ? "So it looks, but it is not proved: a gap may be finer still."
                  : "It does not look so, but nothing is proved: a gap may be finer still."}
              </p>
            ) : (
              <Reply options={OPTIONS} prediction={prediction} truth={proved} />
            )}
            <p>
              The light part is M, as far as a ten-thousandth of each shape tells; the darker, the wider the
              gap. It is the same on all four sides: turn the sign of the angle, and the shape is mirrored;
              turn the sign of s, and it stays as it is. Two spikes run inward along the real line to ½ and
              −½, and the edge between the two circles is ragged, as closely as anybody has looked.
            </p>
          </Truth>
        )
      }
      after={<Here s={s} onMove={move} />}
    >
      <Choices<Which>
        ask={`Choose an s between the two dashed circles. Inside the inner one, |s| below ½, all is dust; outside the outer one, from 0.7071 on, all is in one piece. What is the shape of s = ${complexWords(at)}?`}
        options={OPTIONS}
        prediction={prediction}
        truth={proved}
      />
    </Question>
  );
}

/** The shape at the ring, which may now be moved about M. */
function Here({ s, onMove }: { s: Complex; onMove: (s: Uv) => void }) {
  const maps = useMemo(() => mapsOf(s), [s]);
  const box = useMemo(() => boxAround([maps]), [maps]);
  const judged = useVerdict(maps, EXACT);
  const landmark = LANDMARKS.find(({ s: at }) => at[0] === s[0] && at[1] === s[1]);
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <Picture
        maps={maps}
        box={box}
        label={`The shape of s = ${complexWords(s)}: ${verdictPhrase(judged?.answer ?? null, EXACT)}.`}
      />
      <div class={lessonCss["ask"]}>
        <p>Move the ring on, or go to a landmark.</p>
        <VerdictChip epsilon={EXACT} answer={judged?.answer ?? null} stale={judged?.maps !== maps} />
        <Why answer={judged?.answer} />
        <div class={layout["buttons"]}>
          {LANDMARKS.map(({ s: at, name }) => (
            <Button key={name} pressed={landmark?.name === name} onClick={() => onMove(at)}>
              {name}
            </Button>
          ))}
        </div>
        <p aria-live="polite">{landmark?.about}</p>
      </div>
    </div>
  );
}

/** M, once it is asked for. */
function useQuarter(wanted: boolean): LocusResult | null {
  const channel = useChannel();
  const host = useValue(epoch);
  const [quarter, setQuarter] = useState<LocusResult | null>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: another host has to be asked anew
  useEffect(() => {
    if (!wanted || quarter?.progress === 1) return;
    submit(quarterJob(channel, 361, true, setQuarter));
  }, [wanted, channel, host]);
  return useMemo(() => (quarter ? unfolded(quarter) : null), [quarter]);
}
