import { useMemo } from "preact/hooks";
import { meritWords } from "#format/path-words";
import { shareWords } from "#format/verdict";
import { frond } from "#wasm/core";
import { Choice } from "../../kit/frame/control";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { Chip } from "../../kit/frame/verdict";
import { Square } from "../../kit/locus/locus-square";
import { useChart } from "../../kit/locus/morph-locus";
import { boxAround, type Ends } from "../../kit/maps/morphs";
import { Drawn, middles, PieceNames } from "../../kit/picture/annotated";
import { oneOf } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Choices, Reply } from "../frame/choices";
import { Lesson, Question, Truth } from "../frame/lesson";
import { type Prediction, usePrediction } from "../frame/prediction";
import { Exercises } from "./exercises";
import { Matching, matchingWords } from "./matching";
import css from "./page.module.css";
import { TURNS } from "./pairings";
import { endsOf, FIRST, type First, LAST, turnsOf, usePlan } from "./plan";
import { TEACHING } from "./teaching";

const SIZE = 85;

/** For each map of the first shape the map of the last that it becomes. */
const MATCHINGS = {
  swap: [1, 0, 2],
  same: [0, 1, 2],
  round: [2, 0, 1],
} as const;
type Name = keyof typeof MATCHINGS;
const NAMES: readonly Name[] = ["swap", "same", "round"];
const LETTERS: Record<Name, string> = { swap: "P", same: "Q", round: "R" };

/** What is said to whoever chose one that breaks. */
const WRONG = {
  swap: "In P pieces 1 and 2 have to pass each other. Follow its way on the map below: it crosses the dark.",
  round: "In R all three pieces go round. Follow its way on the map below: it crosses the dark.",
} as const;

/** The wrong pairing. */
export function Page(heading: Heading) {
  const prediction = usePrediction<Name>(null, oneOf(NAMES));
  const guess = prediction.guess ?? "same";
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            To turn one shape into another, one has to say which piece becomes which. Both ends look the same
            however that is settled. What lies between them does not: below is the same moment, half-way, for
            two ways of pairing the pieces.
          </p>
          <p>
            So each pairing has its own map of shapes, as in <a href="#learn/e7">Straight on, or led</a>, and
            its own ways across. For some there is a way on which the shape stays in one piece. For others,
            every way breaks.
          </p>
        </>
      }
      question={<Pairing prediction={prediction} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        { name: "First shape", symbol: "A", value: "Heighway’s dragon, written with three maps" },
        { name: "Last shape", symbol: "B", value: "the gasket" },
        ...NAMES.map((name) => ({
          name: `Pairing ${LETTERS[name]}`,
          value: matchingWords(MATCHINGS[name]),
        })),
        { name: "Turns", value: "the shortest; piece 2 by half a turn, counter-clockwise" },
        { name: "Resolution", symbol: "ε", value: "1/600 of the shape" },
      ]}
      sources={
        <p>
          Burch and Hart take the pairing as given, and name finding one as an open problem (1997). The two
          shapes are those of their Figures 5 to 7, the dragon <a href="#figures/7">reconstructed</a>. The
          pairings and their maps are Frond’s.
        </p>
      }
      studio={{
        href: studioHref({
          a: preset("dragon-3"),
          b: preset(LAST),
          t: 0.5,
          correspondence: [...MATCHINGS[guess]],
          turns: TURNS,
        }),
      }}
    >
      <Between />
    </Lesson>
  );
}

/** Both ends, and two half-way shapes between them. */
function Between() {
  const { from, to } = useMemo(() => endsOf("dragon-3"), []);
  const half = (name: Name) => {
    const options = { u: 0.5, v: 0.5, correspondence: [...MATCHINGS[name]], turns: TURNS };
    return frond.interpolate({ maps: from }, { maps: to }, options).maps;
  };
  // biome-ignore lint/correctness/useExhaustiveDependencies: the ends never change
  const between = useMemo(() => [half("same"), half("swap")], []);
  const shapes = [
    { maps: from, words: "A, the first shape", named: true },
    { maps: between[0] ?? [], words: "half-way by pairing Q", named: false },
    { maps: between[1] ?? [], words: "half-way by pairing P", named: false },
    { maps: to, words: "B, the last shape", named: true },
  ];
  return (
    <div class={css["quadruple"]}>
      {shapes.map(({ maps, words, named }) => (
        <Panel key={words} caption={words}>
          <Drawn maps={maps} box={boxAround([maps])} label={words}>
            {(place) => named && <PieceNames at={middles(maps, boxAround([maps])).map(place)} />}
          </Drawn>
        </Panel>
      ))}
    </div>
  );
}

function Pairing({ prediction }: { prediction: Prediction<Name> }) {
  const { shown, guess } = prediction;
  const ends = useMemo(() => endsOf("dragon-3"), []);
  // Asked for before they are shown: they take a moment.
  const plans = {
    swap: usePlan(ends, MATCHINGS.swap),
    same: usePlan(ends, MATCHINGS.same),
    round: usePlan(ends, MATCHINGS.round),
  };
  const whole = NAMES.filter((name) => plans[name]?.holds);
  const known = NAMES.every((name) => plans[name] !== null);
  const truth = known ? (whole[0] ?? null) : null;
  const broken = NAMES.filter((name) => plans[name] && !plans[name].holds);
  const options = NAMES.map((name) => ({
    value: name,
    label: (
      <span class={css["pairing"]}>
        {LETTERS[name]}
        <Matching matching={MATCHINGS[name]} />
        <span class={css["pairing-words"]}>{matchingWords(MATCHINGS[name])}</span>
      </span>
    ),
    ...(name === "same" ? {} : { wrong: WRONG[name] }),
  }));
  return (
    <Question
      prediction={prediction}
      truth={shown ? truth : null}
      answer={
        known ? (
          <Truth
            line={`You said ${LETTERS[guess ?? "same"]}. ${whole.map((name) => LETTERS[name]).join(" and ") || "None of them"} holds together.`}
          >
            <Reply options={options} prediction={prediction} truth={truth} />
            <p>
              With the other pairings Frond finds no way from A to B that does not break; the best it finds
              opens a gap of{" "}
              {broken.map((name) => `${shareWords(plans[name]?.gap ?? 0)} (${LETTERS[name]})`).join(" and ")}{" "}
              of the diameter. In Q each piece becomes the one that lies as it does itself, and no two pieces
              have to change places.
            </p>
          </Truth>
        ) : (
          <p>Looking for ways across …</p>
        )
      }
      after={<Maps />}
    >
      <Choices<Name>
        ask="Here are three pairings of the dragon’s pieces with those of the gasket. Which of them can be led across in one piece?"
        options={options}
        prediction={prediction}
        truth={shown ? truth : null}
      />
    </Question>
  );
}

/** The maps of shapes of all three pairings. */
function Maps() {
  const [first, setFirst] = useKept<First>("first", "dragon-3", oneOf(FIRST.map(({ value }) => value)));
  const ends = useMemo(() => endsOf(first), [first]);
  return (
    <>
      <div class={layout["controls"]}>
        <Choice label="From" name="First shape" options={FIRST} value={first} onChange={setFirst} />
      </div>
      <div class={layout["triple"]}>
        {NAMES.map((name) => (
          <Chart key={`${first} ${name}`} first={first} ends={ends} name={name} />
        ))}
      </div>
      <p>
        Light is in one piece; the line is the best way that Frond finds from A to B. No rule of thumb decides
        which pairing is good: from the mirrored terdragon Q breaks, though it looks as tidy, and P holds. One
        has to look; the studio does, and offers other pairings beside the one at hand.
      </p>
    </>
  );
}

function Chart({ first, ends, name }: { first: First; ends: Ends; name: Name }) {
  const options = useMemo(
    () => ({ correspondence: [...MATCHINGS[name]], turns: turnsOf(first) }),
    [first, name],
  );
  const wish = useMemo(() => ({ ends, options, size: SIZE }), [ends, options]);
  const field = useChart(wish);
  const plan = usePlan(ends, MATCHINGS[name], first);
  const holds = plan?.holds ?? false;
  const state = plan === null ? "being looked for" : meritWords(plan);
  return (
    <Panel
      name={LETTERS[name]}
      words={matchingWords(MATCHINGS[name])}
      caption={
        <Chip
          tone={plan === null ? "unknown" : holds ? "close" : "broken"}
          text={plan === null ? "Looking …" : holds ? "No gap seen" : "In pieces"}
          aside={plan === null ? "" : holds ? "all the way" : `gap ${shareWords(plan.gap)}`}
        />
      }
    >
      <Square
        field={field}
        label={`The map of shapes of pairing ${LETTERS[name]}, with the best way from A to B: ${state}.`}
        lines={plan ? [{ name: "way", points: plan.points }] : []}
      />
    </Panel>
  );
}
