import { fixed } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import type { MapRow } from "#wasm/api";
import { SliderControl } from "../../kit/frame/control";
import { Formula } from "../../kit/frame/formula";
import layout from "../../kit/frame/layout.module.css";
import { norm, type Point } from "../../kit/maps/pieces";
import { tex } from "../../kit/notation/tex";
import { list, number, oneOf } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import lessonCss from "../frame/lesson.module.css";
import { far, orbit, pushing, repeated } from "../lesson-14/orbit";
import { Track } from "../lesson-14/track";

const UP: Point = [0, 1];
const STEPS = 40;
const TWICE = 2;

export function Exercises() {
  return (
    <>
      <Stretch />
      <ByTurns />
    </>
  );
}

/** A map that more than doubles some lengths and yet leads home. */
function Stretch() {
  const [scale, setScale] = useKept("x1.scale", 0.6, number(0.5, 1.2, 2));
  const [push, setPush] = useKept("x1.push", 1, number(0, 3, 2));
  const map = pushing(scale, push);
  const longest = norm(map);
  // The map has one factor only, its scale: below 1 all points come home, whatever the push.
  const isHome = scale < 1;
  const solved = isHome && longest > TWICE;
  const words = `Some lengths become ${fixed(longest)} times as long; ${isHome ? "all points come home in the end" : "points do not come home"}.`;
  return (
    <Exercise
      number={1}
      ask="Make a map that more than doubles some length in one step, and that still brings every point home."
      hints={[
        "Which of the two numbers decides what happens in the long run?",
        "Leave the scale below 1, and push harder.",
      ]}
      solved={solved}
      status={words}
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Track
          points={orbit(repeated(map, STEPS), UP)}
          reach={2}
          middle={[0.13, 0.7]}
          label={`The way of the point one above the middle. ${words}`}
        />
        <div class={lessonCss["ask"]}>
          <SliderControl label="scale" symbol="s" range={[0.5, 1.2]} value={scale} onChange={setScale} />
          <SliderControl label="push to the side" symbol="k" range={[0, 3]} value={push} onChange={setPush} />
        </div>
      </div>
    </Exercise>
  );
}

const LETTERS = ["A", "B"] as const;
const MAPS: Record<(typeof LETTERS)[number], MapRow> = {
  A: [0.5, 1, 0, 0.5, 0, 0],
  B: [0.5, 0, 1, 0.5, 0, 0],
};
const MOST = 12;
const WANTED = 5;

/** Two maps, each of which leads home, and which together need not. */
function ByTurns() {
  const [letters, setLetters] = useKept<readonly (typeof LETTERS)[number][]>(
    "x2.steps",
    [],
    list(oneOf(LETTERS), 0, MOST),
  );
  const points = orbit(
    letters.map((letter) => MAPS[letter]),
    UP,
  );
  const now = far(points.at(-1) ?? UP);
  const row = letters.length === 0 ? "no step yet" : letters.join(" ");
  return (
    <Exercise
      number={2}
      ask="Map A halves everything and pushes to the side by what is up. Map B halves everything and pushes up by what is across. Either one alone brings every point home. Choose one at each step, and take the point more than 5 times as far from the middle as it was, in 12 steps at most."
      hints={[
        "Take only A: what is up gets less and less, and so there is less and less to push by.",
        "Give each map what it needs: A makes much across, and B pushes by it. Begin with A.",
      ]}
      solved={now > WANTED}
      status={`${now.toFixed(2)} times as far as at the start, after ${letters.length} step${letters.length === 1 ? "" : "s"}${now > WANTED ? ": together these two maps do not bring every point home" : ""}.`}
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Track
          points={points}
          reach={5.2}
          middle={[0.2, 0.9]}
          label={`The way of the point, ${row}: it is ${now.toFixed(2)} times as far as at the start.`}
        />
        <div class={lessonCss["ask"]}>
          <div class={layout["buttons"]}>
            {LETTERS.map((letter) => (
              <Button
                key={letter}
                disabled={letters.length >= MOST}
                onClick={() => setLetters([...letters, letter])}
              >
                {letter}
              </Button>
            ))}
            <Button
              icon="back"
              disabled={letters.length === 0}
              onClick={() => setLetters(letters.slice(0, -1))}
            >
              Back
            </Button>
            <Button icon="reset" disabled={letters.length === 0} onClick={() => setLetters([])}>
              Clear
            </Button>
          </div>
          <p class="number">{row}</p>
          <p class={layout["hint"]}>
            A: <Formula tex={tex`(x, y) \mapsto (\tfrac12 x + y,\ \tfrac12 y)`} />, B:{" "}
            <Formula tex={tex`(x, y) \mapsto (\tfrac12 x,\ x + \tfrac12 y)`} />
          </p>
        </div>
      </div>
    </Exercise>
  );
}
