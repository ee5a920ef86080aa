import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { gasket, HEIGHT } from "../../kit/maps/families";
import type { Point } from "../../kit/maps/pieces";
import { Picture } from "../../kit/picture/picture";
import { number, text } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import lessonCss from "../frame/lesson.module.css";
import { Board } from "./board";
import { CORNERS, landed, MOST_AIMED, TARGET, Throws } from "./throws";

const WHOLE = { x0: 0, y0: 0, x1: 1, y1: HEIGHT };

export function Exercises() {
  return (
    <>
      <Aim />
      <Farther />
    </>
  );
}

const towards = (point: Point, corner: number): Point => {
  const [u, v] = CORNERS[corner] ?? point;
  return [(point[0] + u) / 2, (point[1] + v) / 2];
};
/** The triangle of a piece of a piece. */
const FRAMED = CORNERS.map((corner) => TARGET.reduceRight((point, digit) => towards(point, digit), corner));

/** The last throw is the first digit. */
function Aim() {
  const [thrown, setThrown] = useKept("x1.throws", "", text(/[123]{0,4}/));
  const game = useMemo(() => {
    const now = new Throws();
    for (const digit of thrown) now.throwTo(Number(digit) - 1);
    return now;
  }, [thrown]);
  const where = landed(game.corners);
  const words = {
    none: "No throw yet.",
    there:
      "In the framed triangle: the last throw chose the large piece, the one before it the small piece within.",
    large: "It is in the lower right piece, but in another part of it. Which throw decides that?",
    turned: "The same throws in the other order would do: this is piece 2 of piece 3.",
    elsewhere: "It is not in the lower right piece. Which throw decides in which large piece the mark is?",
  }[where];
  return (
    <Exercise
      number={1}
      ask="Throw the mark into the framed triangle, the top part of the piece at the lower right. You have four throws at most."
      hints={[
        "However one came there, the last throw halves the way to its corner. So in which large piece is the mark?",
        "So the last throw has to be towards 2. Before it the mark has to be where the frame lies within the whole: on top.",
      ]}
      solved={where === "there"}
      status={words}
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Board
          game={game}
          count={game.count}
          holes={[FRAMED]}
          label={`The board after ${game.count} throws, with a triangle framed at the top of the lower right piece. ${words}`}
        />
        <div class={lessonCss["ask"]}>
          <div class={layout["buttons"]}>
            <span class={layout["choice-label"]} aria-hidden="true">
              Throw towards
            </span>
            {["1", "2", "3"].map((digit) => (
              <Button
                key={digit}
                description={`Throw towards corner ${digit}`}
                disabled={thrown.length >= MOST_AIMED}
                onClick={() => setThrown(thrown + digit)}
              >
                {digit}
              </Button>
            ))}
            <Button icon="reset" disabled={thrown === ""} onClick={() => setThrown("")}>
              Clear
            </Button>
          </div>
          <p class="number">Thrown: {thrown === "" ? "nothing" : [...thrown].join(", ")}</p>
        </div>
      </div>
    </Exercise>
  );
}

const GAP = 0.2;

/** Another rule: the jump goes farther. */
function Farther() {
  const [part, setPart] = useKept("x2.part", 0.5, number(0.4, 0.8, 2));
  const gap = 2 * part - 1;
  const maps = useMemo(() => gasket(1 - part), [part]);
  const solved = Math.abs(gap - GAP) < 1e-9;
  const words =
    gap < -1e-9
      ? "The parts overlap: one jumps less than half of the way."
      : gap < 1e-9
        ? "The parts touch in single points."
        : `Between two parts there is a gap of ${fixed(gap)} of the side.`;
  return (
    <Exercise
      number={2}
      ask="Change the rule: jump a larger part of the way, and the three parts of the picture come apart. How far must one jump if there is to be a gap of a fifth of the side, 0.2, between two parts?"
      hints={[
        "Whoever jumps 0.7 of the way is left with 0.3 of it: every part is 0.3 times as large as the whole.",
        "Along the bottom edge lie two parts and the gap. They sum to 1.",
      ]}
      solved={solved}
      status={words}
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Picture
          maps={maps}
          box={WHOLE}
          label={`Where the marks fall when one jumps ${fixed(part)} of the way. ${words}`}
        />
        <div class={lessonCss["ask"]}>
          <SliderControl
            label="part of the way"
            range={[0.4, 0.8]}
            step={0.01}
            value={part}
            onChange={(next) => setPart(Number(next.toFixed(2)))}
          />
        </div>
      </div>
    </Exercise>
  );
}
