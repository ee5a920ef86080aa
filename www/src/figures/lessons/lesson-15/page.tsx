import { useMemo } from "preact/hooks";
import { SliderControl } from "../../kit/frame/control";
import { Formula } from "../../kit/frame/formula";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { gasket } from "../../kit/maps/families";
import { tex } from "../../kit/notation/tex";
import { middles, PieceNames } from "../../kit/picture/annotated";
import { number } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { ChoiceQuestion } from "../frame/choice-question";
import { Lesson } from "../frame/lesson";
import lessonCss from "../frame/lesson.module.css";
import { type Prediction, useChoice } from "../frame/prediction";
import { byArea, marksIn, play, share } from "./dice";
import { Evenly, Shares } from "./exercises";
import { Shade } from "./shade";
import { FERN, TRIANGLE } from "./shapes";
import { TEACHING } from "./teaching";
import { percent, useWeights, Weights } from "./weights";

const MAPS = gasket(0.5);
const MANY = 60_000;
const THROWS = 10_000;
/** The fern above five pairs of leaflets: its second map, five times. */
const TIP = [1, 1, 1, 1, 1] as const;
/** The cell of few marks, in pixels: one of them is seen. */
const FINE = 1.5;
const FAIR = [1, 1, 1, 1] as const;

/** The chances of the die: not the shape, but its shade. */
export function Page(heading: Heading) {
  const prediction = useChoice<Seen>(OPTIONS);
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            The chaos game again: throw a die, jump half of the way to a corner, leave a mark. But this die is
            loaded. Each of its three faces has a weight, and the heavier a face is, the more often it comes
            up.
          </p>
          <p>
            There are sixty thousand marks below; where there are more of them the colour is stronger. Drag a
            weight, and see what changes and what does not.
          </p>
        </>
      }
      question={<Ferns prediction={prediction} />}
      exercises={
        <>
          <Shares />
          <Evenly />
        </>
      }
      teaching={TEACHING}
      parameters={[
        {
          name: "Chance of face k",
          symbol: tex`p_k`,
          value: "its weight, divided by the sum of all weights",
        },
        { name: "Marks of the gasket", value: "60 000, from the point (0, 0) of it" },
        { name: "Marks of the fern", value: "10 000, from the foot of its stem" },
        { name: "Die by areas", value: "|det| of each map; the stem, which has none, 1 of 100 of all areas" },
      ]}
      sources={
        <>
          <p>
            John Hutchinson (<cite>Fractals and self similarity</cite>, 1981) proved that maps{" "}
            <Formula tex={tex`f_1, \dots, f_N`} /> which shrink all distances by a factor below 1, with
            chances <Formula tex={tex`p_1, \dots, p_N`} /> above 0 that sum to 1, have exactly one way{" "}
            <Formula>μ</Formula> of sharing out a whole of 1 over a bounded part of the plane such that{" "}
            <Formula tex={tex`\mu(B) = p_1\, \mu(f_1^{-1}(B)) + \dots + p_N\, \mu(f_N^{-1}(B))`} copy /> for
            every (Borel) set <Formula>B</Formula>. It is called the invariant measure. Whatever the chances
            are, the set on which it lies, its support, is the attractor.
          </p>
          <p>
            That the shares of the throws come to those of <Formula>μ</Formula>, with probability 1 and for
            every part whose edge has no share, is a theorem of John Elton (1987). Michael Barnsley chooses
            chances by areas in <cite>Fractals Everywhere</cite> (1988), and the fern is his.
          </p>
        </>
      }
      studio={{ href: studioHref({ a: preset("fern"), b: preset("gasket") }) }}
    >
      <Loaded />
    </Lesson>
  );
}

function Loaded() {
  const die = useWeights("weights", [1, 0.4, 0.2]);
  const game = useMemo(() => play(MAPS, die.weights, MANY), [die.weights]);
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <Shade
        game={game}
        box={TRIANGLE}
        label={`The gasket, shaded by marks: ${die.each.map((chance, i) => `${percent(chance)} in piece ${i + 1}`).join(", ")}.`}
      >
        {(place) => <PieceNames at={middles(MAPS, TRIANGLE).map(place)} />}
      </Shade>
      <div class={lessonCss["ask"]}>
        <Weights of={die} />
      </div>
    </div>
  );
}

type Seen = "same" | "low" | "stem";
const OPTIONS = [
  {
    value: "same",
    label: "The same fern: a fair die favours no part of it",
    wrong:
      "It favours no map. But one of the four maps makes most of the fern, and the others only a little.",
  },
  { value: "low", label: "The lower leaflets in full, and hardly anything of the tip" },
  {
    value: "stem",
    label: "Only the stem: it takes a quarter of the marks and hides the rest",
    wrong:
      "The stem does get a quarter of the marks, but they hide nothing: the other three quarters are elsewhere.",
  },
] as const;

function Ferns({ prediction }: { prediction: Prediction<Seen> }) {
  const { shown } = prediction;
  const { maps } = useMemo(() => preset("fern"), []);
  const areas = useMemo(() => byArea(maps), [maps]);
  const fair = useMemo(() => play(maps, FAIR, THROWS), [maps]);
  const good = useMemo(() => play(maps, areas, THROWS), [maps, areas]);
  const found = marksIn(fair, TIP);
  return (
    <ChoiceQuestion<Seen>
      prediction={prediction}
      ask="A fern has four maps: 1 makes the stem, 2 all that is above the first two leaflets, 3 and 4 these two. Somebody draws it with ten thousand throws of a fair die with four faces. What is seen?"
      options={OPTIONS}
      truth="low"
      beside={
        <Panel caption={shown ? "By a fair die." : "By another die. The numbers are those of the maps."}>
          <Shade
            game={shown ? fair : good}
            box={FERN}
            shape={1}
            grain={FINE}
            label={
              shown
                ? `Barnsley’s fern by a fair die: dense below, and ${found} of ${THROWS} marks in its upper half.`
                : "Barnsley’s fern by another die, and on each of its four pieces the number of its map."
            }
          >
            {(place) => <PieceNames at={middles(maps, FERN).map(place)} />}
          </Shade>
        </Panel>
      }
      after={<Better />}
      line={`Of 10 000 throws, ${found} went into the fern above its fifth pair of leaflets, which is nearly half of its length.`}
    >
      <p>
        That part is map 2 five times in a row. A fair die throws it once in 4 · 4 · 4 · 4 · 4 = 1024 times.
        Map 2 makes {Math.round(100 * (areas[1] ?? 0))} of 100 of the area. A die that goes by areas throws it
        so often, and five times in a row in {Math.round(100 * share(areas, TIP))} of 100.
      </p>
      <p>
        The shape is settled by the maps alone. By any die on which no face has chance 0, marks come in the
        long run, with probability 1, as near as you like to each of its points. What the chances settle is
        the shade: which share of the marks each part gets. That for given maps there is exactly one shape,
        and for given chances exactly one shade, was proved by John Hutchinson (1981).
      </p>
    </ChoiceQuestion>
  );
}

const LAPPED = gasket(0.64);

/** The fern by dice from fair to areas, and what becomes of overlaps. */
function Better() {
  const { maps } = useMemo(() => preset("fern"), []);
  const [to, setTo] = useKept("dice", 1, number(0, 1, 2));
  const areas = useMemo(() => byArea(maps), [maps]);
  const weights = useMemo(() => areas.map((area) => (1 - to) / areas.length + to * area), [areas, to]);
  const game = useMemo(() => play(maps, weights, THROWS), [maps, weights]);
  const lapped = useMemo(() => play(LAPPED, [1, 1, 1], 3 * MANY), []);
  const said = weights.map((weight, i) => `map ${i + 1} ${percent(weight)}`).join(", ");
  return (
    <>
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Panel caption={`The fern with 10 000 throws: ${said}.`}>
          <Shade
            game={game}
            box={FERN}
            shape={1}
            grain={FINE}
            label={`The fern: ${marksIn(game, TIP)} of 10 000 marks in nearly the upper half of its length.`}
          />
        </Panel>
        <Panel caption="Pieces that overlap, by a fair die: where two lie over each other the marks of both add up, and the colour is stronger.">
          <Shade
            game={lapped}
            box={TRIANGLE}
            shape={1}
            grain={2}
            label="Three triangles that overlap: stronger where two of them lie over each other."
          />
        </Panel>
      </div>
      <div class={layout["controls"]}>
        <SliderControl
          label="the fern’s die, from fair to areas"
          value={to}
          text={to === 0 ? "fair" : to === 1 ? "by areas" : `${Math.round(100 * to)} of 100`}
          onChange={setTo}
        />
      </div>
    </>
  );
}
