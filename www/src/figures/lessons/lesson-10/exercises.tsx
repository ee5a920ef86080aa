import { useMemo } from "preact/hooks";
import { shareWords } from "#format/verdict";
import type { PathPlan } from "#wasm/api";
import { frond } from "#wasm/core";
import { Choice } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { boxAround } from "../../kit/maps/morphs";
import { Drawn, middles, PieceNames } from "../../kit/picture/annotated";
import { oneOf } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import lessonCss from "../frame/lesson.module.css";
import { Matching, matchingWords } from "./matching";
import { kept, nameOf, PAIRINGS, type Pairing, TURNS } from "./pairings";
import { endsOf, usePlan } from "./plan";

/** A gap, in shares of the diameter, below which a pairing all but holds. */
const NARROW = 0.01;

export function Exercises() {
  return (
    <>
      <Tried
        number={1}
        ask="Pairing P lets pieces 1 and 2 change places, and breaks. Find another pairing in which two pieces change places, and which can be led across in one piece."
        hints={[
          "In such a pairing one piece keeps its number. There are three of them, and P is one.",
          "Let piece 1 keep its number, or piece 2.",
        ]}
        asked={(pairing) => kept(pairing) === 1}
        other="In this pairing it is not two pieces that change places."
        found={({ holds }) => holds}
      />
      <Tried
        number={2}
        ask="In two pairings no piece keeps its number: all go round. Both break. Which of them comes nearer to holding?"
        hints={[
          "What tells how badly a pairing breaks is the widest gap on its best way.",
          "Look at both, and compare their gaps. One is a tenth of the other.",
        ]}
        asked={(pairing) => kept(pairing) === 0}
        other="In this pairing a piece keeps its number."
        found={({ holds, gap }) => !holds && gap < NARROW}
      />
    </>
  );
}

interface TriedProps {
  number: number;
  ask: string;
  hints: readonly string[];
  /** Whether a pairing is of the kind that is asked for, and what is said of another. */
  asked: (pairing: Pairing) => boolean;
  other: string;
  found: (plan: PathPlan) => boolean;
}

const OPTIONS = PAIRINGS.map((pairing) => ({ value: nameOf(pairing), label: nameOf(pairing) }));
const [FIRST = PAIRINGS[0] as Pairing] = PAIRINGS;

/** One of the six pairings, and the best way that it has. */
function Tried({ number, ask, hints, asked, other, found }: TriedProps) {
  const [name, setName] = useKept(
    `x${number}.pairing`,
    nameOf(FIRST),
    oneOf(OPTIONS.map(({ value }) => value)),
  );
  const pairing = PAIRINGS.find((one) => nameOf(one) === name) ?? FIRST;
  const ends = useMemo(() => endsOf("dragon-3"), []);
  const plan = usePlan(ends, pairing);
  const between = useMemo(
    () =>
      frond.interpolate(
        { maps: ends.from },
        { maps: ends.to },
        { u: 0.5, v: 0.5, correspondence: [...pairing], turns: TURNS },
      ).maps,
    [ends, pairing],
  );
  const box = useMemo(() => boxAround([between]), [between]);
  const way =
    plan === null
      ? "Looking for a way …"
      : plan.holds
        ? "There is a way in one piece."
        : `The best way that is found opens a gap of ${shareWords(plan.gap)}.`;
  return (
    <Exercise
      number={number}
      ask={ask}
      hints={hints}
      solved={plan && asked(pairing) && found(plan)}
      status={`${way} ${asked(pairing) ? "" : other}`}
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Drawn maps={between} box={box} label={`Half-way by the pairing ${matchingWords(pairing)}.`}>
          {(place) => <PieceNames at={middles(between, box).map(place)} />}
        </Drawn>
        <div class={lessonCss["ask"]}>
          <Choice
            label="1, 2, 3 become"
            name="What pieces 1, 2 and 3 become"
            options={OPTIONS}
            value={name}
            onChange={setName}
          />
          <Matching matching={pairing} wide />
          <p class={layout["hint"]}>The picture is the shape half-way on the straight line.</p>
        </div>
      </div>
    </Exercise>
  );
}
