import { fixed } from "#format/numbers";
import { type Field, list, number } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import { Scale, Trio } from "../lesson-1/exercises";
import { apart, gapOf, PAIRS, type Scales } from "../lesson-1/three";

const SCALES: Scales = [0.52, 0.42, 0.28];
const STORED = list(number(0.2, 0.8, 2), 3, 3) as Field<Scales>;
const WANTED = 0.1;
const NAMES = [1, 2, 3] as const;

export function Exercises() {
  return (
    <>
      <OfWidth />
      <Close />
    </>
  );
}

const stepsWords = (scales: Scales) =>
  PAIRS.map((pair) => `${pair[0] + 1} to ${pair[1] + 1}: ${fixed(Math.max(0, apart(scales, pair)))}`).join(
    ", ",
  );

/** A gap of a width that is asked, by one number. */
function OfWidth() {
  const [third, setThird] = useKept("x1.third", SCALES[2], number(0.2, 0.8, 2));
  const scales: Scales = [SCALES[0], SCALES[1], third];
  const gap = gapOf(scales);
  const solved = Math.abs(gap - WANTED) < 1e-9;
  return (
    <Exercise
      number={1}
      ask="Change only piece 3, so that the gap of the whole shape is exactly 0.10."
      hints={[
        "The gap is the widest step that cannot be avoided. Which step is it now, and from which piece does it lead to piece 3?",
        "The step from 1 to 3 is what is left of 1 after both of their scales: 0.52 and that of piece 3.",
      ]}
      solved={solved}
      status={`${stepsWords(scales)}. The gap is ${fixed(gap)}${solved ? ", the second of the three steps in length." : "."}`}
    >
      <Trio scales={scales}>
        <Scale piece={3} value={third} onChange={setThird} />
      </Trio>
    </Exercise>
  );
}

/** The least change of one scale that closes the gap: no other one needs less than this. */
const CHANGE = 0.2;

function Close() {
  const [scales, setScales] = useKept<Scales>("x2.scales", SCALES, STORED);
  const changes = scales.map((scale, i) => Math.abs(scale - (SCALES[i] ?? 0)));
  const changed = changes.filter((change) => change > 1e-9).length;
  const isWhole = gapOf(scales) === 0;
  const much = Math.max(...changes);
  const solved = isWhole && changed === 1 && much < CHANGE + 1e-9;
  const words = !isWhole
    ? `The gap is ${fixed(gapOf(scales))}.`
    : changed > 1
      ? "The gap is closed, but by more than one number."
      : solved
        ? "The gap is closed, by the least change of one number."
        : `The gap is closed by a change of ${fixed(much)}. Another piece needs less.`;
  return (
    <Exercise
      number={2}
      ask="Close the gap with one number: change the scale of one piece only, and by as little as you can."
      hints={[
        "Piece 2 touches piece 1 soon, and then piece 3 still stands alone: it would have to grow by 0.30 to reach that one, too. Which pieces can the others reach?",
        "Piece 1 reaches piece 2 at once and piece 3 at scale 0.72. How much would piece 3 have to grow?",
      ]}
      solved={solved}
      status={words}
    >
      <Trio scales={scales}>
        {NAMES.map((piece, i) => (
          <Scale
            key={piece}
            piece={piece}
            value={scales[i] ?? 0}
            onChange={(next) =>
              setScales(scales.map((scale, at) => (at === i ? next : scale)) as unknown as Scales)
            }
          />
        ))}
      </Trio>
    </Exercise>
  );
}
