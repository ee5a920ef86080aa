import type { ComponentChildren } from "preact";
import { orbitOf, preimageOf } from "#geometry/maps/orbit";
import { isIn } from "#geometry/maps/target";
import { Button } from "#ui/controls/Button";
import { useFocusKept } from "#ui/orbit/focus";
import { MapButtons } from "#ui/orbit/MapButtons";
import layout from "../../kit/frame/layout.module.css";
import type { Point } from "../../kit/maps/pieces";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import lessonCss from "../frame/lesson.module.css";
import { BOARD, letters, lettersOf, MAPS, MARKED, readSoFar, SOUGHT, WANTED } from "./cells";
import { Field, useColours } from "./field";
import { Keyed } from "./keyed";

export function Exercises() {
  return (
    <>
      <Reach />
      <Read />
    </>
  );
}

interface ChosenProps {
  name: string;
  verb: string;
  most: number;
  written: string;
  onWritten: (next: string) => void;
  children: ComponentChildren;
}

/** Letters that are chosen one by one, and taken back, beside a picture of what comes of them. */
function Chosen({ name, verb, most, written, onWritten, children }: ChosenProps) {
  const add = (letter: number) => {
    if (written.length < most) onWritten(`${written}${letter + 1}`);
  };
  const back = () => onWritten(written.slice(0, -1));
  const controls = useFocusKept(written === "");
  return (
    <Keyed onMap={add} onBack={back}>
      {children}
      <div class={lessonCss["ask"]} ref={controls}>
        <MapButtons
          verb={verb}
          count={MAPS.length}
          colours={useColours()}
          disabled={written.length >= most}
          onMap={add}
        />
        <div class={layout["buttons"]}>
          <Button icon="back" disabled={written === ""} onClick={back}>
            Back
          </Button>
          <Button icon="reset" disabled={written === ""} onClick={() => onWritten("")}>
            Clear
          </Button>
        </div>
        <p class="number">
          {name}: {written === "" ? "nothing yet" : [...written].join(" ")}
        </p>
      </div>
    </Keyed>
  );
}

/** A cell of four letters takes four throws. */
function Reach() {
  const most = WANTED.length;
  const [thrown, setThrown] = useKept("x1.throws", "", letters(0, most));
  const target = lettersOf(WANTED);
  const throws = lettersOf(thrown);
  const here = orbitOf(MAPS, BOARD.start, throws).at(-1) ?? BOARD.start;
  const solved = isIn(BOARD, target, here);
  const left = most - throws.length;
  const words = solved
    ? `In the cell ${WANTED}: the throws are its address, read backwards.`
    : left === most
      ? "No throw yet."
      : left > 0
        ? `Not there yet: ${left} throw${left === 1 ? "" : "s"} left.`
        : "Not in the framed cell. Which throw decides in which large piece the point is?";
  return (
    <Exercise
      number={1}
      ask="The framed cell is one of 81 of its size. Bring the point into it with four throws."
      hints={[
        "In which large piece is the cell? That is the last throw.",
        `The address of the cell is ${WANTED}. Throw its letters from the last to the first.`,
      ]}
      solved={solved}
      status={words}
    >
      <Chosen name="Thrown" verb="Throw towards" most={most} written={thrown} onWritten={setThrown}>
        <Field
          label={`The gasket with a small cell framed in its piece 3, after ${throws.length} throws. ${words}`}
          target={target}
          throws={throws}
        />
      </Chosen>
    </Exercise>
  );
}

/** The marked point, and where the inverse of each map takes it. */
function enlarged(chosen: readonly number[]): Point[] {
  const points = [MARKED];
  let here = MARKED;
  for (const letter of chosen) {
    const map = MAPS[letter];
    here = (map && preimageOf(map, here)) ?? here;
    points.push(here);
  }
  return points;
}

/** The other way round: each inverse map takes one letter off the address. */
function Read() {
  const [said, setSaid] = useKept("x2.address", "", letters(0, SOUGHT.length));
  const chosen = lettersOf(said);
  const points = enlarged(chosen);
  const so = readSoFar(said);
  const last = said.at(-1);
  const words = {
    none: "No letter yet.",
    right: `Piece ${last} is right: enlarged to the whole, it has taken the point along. In which piece is it now?`,
    done: `The point lies in the cell ${SOUGHT}.`,
    wrong: "The point was not in one of the pieces that you chose: enlarged, it left the triangle. Go back.",
  }[so];
  return (
    <Exercise
      number={2}
      ask="Now backwards. In which cell of four letters does point 0 lie? Choose the piece that the point is in: the piece is enlarged to the whole, and the point goes along. Then choose again."
      hints={[
        "Point 0 is in the large piece at the lower right. That is the first letter.",
        "After the first letter the point is in the piece on top.",
      ]}
      solved={so === "done"}
      status={words}
    >
      <Chosen
        name="Address"
        verb="The point is in piece"
        most={SOUGHT.length}
        written={said}
        onWritten={setSaid}
      >
        <Field
          label={`The gasket with a point in it, enlarged ${chosen.length} times. ${words}`}
          throws={chosen}
          points={points}
          inverse
        />
      </Chosen>
    </Exercise>
  );
}
