import { Button } from "#ui/controls/Button";
import { GASKET, LIFT_BOX } from "../../fujimoto/deformations/lifted-gasket";
import layout from "../../kit/frame/layout.module.css";
import { apply, compose, type Point } from "../../kit/maps/pieces";
import { Drawn } from "../../kit/picture/annotated";
import { text } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import lessonCss from "../frame/lesson.module.css";
import { problem, turned } from "./codes";
import css from "./exercises.module.css";

const CODE = "1132";
const LETTERS = ["1", "2", "3"] as const;
const CORNERS: readonly Point[] = [
  [0, 0],
  [1, 0],
  [0, 1],
];

export function Exercises() {
  return (
    <>
      <Read
        number={1}
        kept={0}
        ask={`The small piece ${CODE} is framed. All of its letters are turned round. Which piece does it take its pull from?`}
        hints={["Read the code from its last letter to its first.", "It begins with 2, and ends with 1."]}
      />
      <Read
        number={2}
        kept={1}
        ask={`Now the locality is 1: the first letter stays as it is, and only the others are turned round. Which piece does ${CODE} take its pull from?`}
        hints={["Cover the first letter, and turn round what is left.", "The letters 132 become 231."]}
      />
    </>
  );
}

interface ReadProps {
  number: number;
  /** So many letters stay. */
  kept: number;
  ask: string;
  hints: readonly string[];
}

/** A code to be read the other way round; both pieces are shown. */
function Read({ number, kept, ask, hints }: ReadProps) {
  const [said, setSaid] = useKept(`x${number}.code`, "", text(/[123]{0,4}/));
  const wrong = problem(CODE, kept, said);
  const solved = wrong === "";
  return (
    <Exercise
      number={number}
      ask={ask}
      hints={hints}
      solved={solved}
      status={
        said === ""
          ? "No letter yet."
          : solved
            ? `${CODE} takes the pull of ${turned(CODE, kept)}, which is ${kept === 0 ? "in piece 23, next to the middle of the long side" : "in piece 1 as well"}.`
            : said.length < CODE.length
              ? `${said} …`
              : wrong
      }
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Drawn
          maps={GASKET}
          box={LIFT_BOX}
          label={`The gasket with piece ${CODE} framed${said === "" ? "" : `, and piece ${said}, dashed`}.`}
        >
          {(place) => (
            <>
              <Frame code={CODE} place={place} />
              {said !== "" && <Frame code={said} place={place} dashed />}
            </>
          )}
        </Drawn>
        <div class={lessonCss["ask"]}>
          <p class={css["code"]}>
            {CODE} → {said.padEnd(CODE.length, "·")}
          </p>
          <div class={layout["buttons"]}>
            {LETTERS.map((letter) => (
              <Button
                key={letter}
                disabled={said.length >= CODE.length}
                onClick={() => setSaid(said + letter)}
              >
                {letter}
              </Button>
            ))}
            <Button icon="back" disabled={said === ""} onClick={() => setSaid(said.slice(0, -1))}>
              Back
            </Button>
          </div>
          <p class={layout["hint"]}>1 is at the lower left, 2 at the right, 3 on top.</p>
        </div>
      </div>
    </Exercise>
  );
}

interface FrameProps {
  code: string;
  place: (point: Point) => Point;
  dashed?: boolean;
}

/** The triangle around a piece. */
function Frame({ code, place, dashed = false }: FrameProps) {
  const [first, ...rest] = [...code].flatMap((letter) => {
    const map = GASKET[Number(letter) - 1];
    return map ? [map] : [];
  });
  if (!first) return null;
  const map = rest.reduce((outer, inner) => compose(outer, inner), first);
  const corners = CORNERS.map((corner) => place(apply(map, corner)).join(" "));
  return <path class={`${css["frame"]} ${dashed ? css["dashed"] : ""}`} d={`M${corners.join("L")}Z`} />;
}
