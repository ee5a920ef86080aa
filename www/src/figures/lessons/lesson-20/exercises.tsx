import type { LocusResult } from "#compute/results";
import { fixed } from "#format/numbers";
import { shareOf, shareWords } from "#format/verdict";
import type { Uv } from "#geometry/path";
import type { Connectedness } from "#wasm/api";
import { SliderControl } from "../../kit/frame/control";
import { Formula } from "../../kit/frame/formula";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { tex } from "../../kit/notation/tex";
import { point } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import { Chart } from "./chart";
import { Here, usePlace } from "./here";
import { isBorder, isNarrow, LINE, NARROW, WITHIN } from "./map";
import css from "./page.module.css";
import { Coordinates } from "./touching";

/** The map, once the question is answered; covered until then. */
interface ExercisesProps {
  field: LocusResult | null;
}

export function Exercises(props: ExercisesProps) {
  return (
    <>
      <NarrowGap {...props} />
      <Border />
    </>
  );
}

function NarrowGap({ field }: ExercisesProps) {
  const [at, setAt] = useKept<Uv>("x1.place", [0.5, 0.5], point(-1, 2));
  const place = usePlace(at);
  const { answer } = place;
  return (
    <Exercise
      number={1}
      ask={`Find a shape that is in pieces, but by less than ${100 * NARROW}% of its size: a gap that hardly anybody would see.`}
      hints={[
        "Gaps do not jump: they close little by little as you come near to what is whole. So go towards the light.",
        "Stay at v = 0.5 and bring u down from 0.5 in small steps. Somewhere between 0.47 and 0.44 the gap closes.",
      ]}
      solved={answer && isNarrow(answer)}
      status={gapWords(answer)}
    >
      <div class={css["map-and-shape"]}>
        <Panel>
          <Chart field={field} label="The map of shapes" point={at} onMove={setAt} />
        </Panel>
        <Panel>
          <Here at={at} of={place} />
        </Panel>
      </div>
      <Coordinates at={at} onMove={setAt} step={0.01} />
    </Exercise>
  );
}

function gapWords(answer: Connectedness | null): string {
  switch (answer?.verdict) {
    case undefined:
      return "Looking …";
    case "disconnected":
      return `The gap is ${shareWords(shareOf(answer))} of the size.`;
    case "connected":
      return "This one is whole: there is no gap.";
    default:
      return "Of this one nothing is proved.";
  }
}

const SIDES = ["First place", "Second place"] as const;

function Border() {
  const [places, setPlaces] = useKept<[number, number]>(
    "x2.places",
    [LINE.u0, LINE.u1],
    point(LINE.u0, LINE.u1),
  );
  const [first, second] = [usePlace([places[0], LINE.v]), usePlace([places[1], LINE.v])];
  const both = [first, second];
  const known = first.answer !== null && second.answer !== null;
  const answers = both.map(({ answer }) => answer);
  const move = (i: number, u: number) => {
    const next = Math.round(u / LINE.step) * LINE.step;
    setPlaces(i === 0 ? [next, places[1]] : [places[0], next]);
  };
  return (
    <Exercise
      number={2}
      ask={
        <>
          Two places on the line <Formula tex={tex`v = ${LINE.v}`} />: the first is in one piece, the second
          in pieces. So there is a border between them. Find it: bring both places within {WITHIN} of each
          other, one of them proved in one piece, the other proved in pieces.
        </>
      }
      hints={[
        "Move one place to the middle between both. Is the shape there whole? Then the border is on its other side.",
        "Halve like this again and again. Eight halvings bring 0.5 below 0.002.",
      ]}
      solved={known ? isBorder(places, answers) : null}
      status={`They are ${fixed(Math.abs(places[0] - places[1]), 3)} apart.`}
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        {both.map((place, i) => (
          <Panel key={SIDES[i]}>
            <Here at={[places[i] ?? 0, LINE.v]} of={place} />
            <SliderControl
              label={SIDES[i] ?? ""}
              symbol="u"
              range={[LINE.u0, LINE.u1]}
              step={LINE.step}
              value={places[i] ?? 0}
              text={fixed(places[i] ?? 0, 3)}
              onChange={(u) => move(i, u)}
            />
          </Panel>
        ))}
      </div>
    </Exercise>
  );
}
