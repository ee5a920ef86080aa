import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { SliderControl } from "../../kit/frame/control";
import { Formula } from "../../kit/frame/formula";
import layout from "../../kit/frame/layout.module.css";
import { tex } from "../../kit/notation/tex";
import { number, whole } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import { isTheSame, SHAPE, turnedMaps } from "./turned";
import { Turning } from "./turning";

export function Exercises() {
  return (
    <>
      <Itself />
      <Moved />
    </>
  );
}

/** A turn that leaves the maps the same, in another order. */
function Itself() {
  const [degrees, setDegrees] = useKept("x1.turn", 30, whole(0, 360));
  const maps = useMemo(() => turnedMaps(SHAPE, degrees), [degrees]);
  const same = isTheSame(SHAPE, maps);
  const none = degrees % 360 === 0;
  return (
    <Exercise
      number={1}
      ask="Turn the maps so that they are the same four as at the beginning, only in another order. It is to be a real turn: not by 0° or 360°."
      hints={[
        "The top corner stays where it is. Where do the three corners of the foot have to go?",
        "Each to the place of the next one. Three such turns are a whole one.",
      ]}
      solved={same && !none}
      status={
        same
          ? none
            ? "The same four maps, but nothing is turned."
            : `By ${degrees}° the maps change places among themselves, so the shape is the same.`
          : `Turned by ${degrees}° these are other maps.`
      }
    >
      <Turning degrees={degrees} onDegrees={setDegrees} maps={maps} />
    </Exercise>
  );
}

/** A move of the whole is half of a move in a map that halves. */
const SHIFT = 0.6;

function Moved() {
  const [shift, setShift] = useKept("x2.shift", 0.6, number(0, 1.2, 2));
  const moved = 2 * shift;
  const solved = Math.abs(moved - SHIFT) < 1e-9;
  return (
    <Exercise
      number={2}
      ask={
        <>
          Now the whole shape is to be moved to the right by {SHIFT}, not turned. Each map is{" "}
          <Formula tex={tex`f(x) = \frac{1}{2} x + t`} />. By how much does each shift <Formula>t</Formula>{" "}
          have to change?
        </>
      }
      hints={[
        "Take a point of the moved shape, move it back by 0.6, halve it, add t, and move it on by 0.6.",
        "Half of what was moved back is lost: −0.3 + 0.6.",
      ]}
      solved={solved}
      status={`With shifts that are ${fixed(shift)} more the shape moves by ${fixed(moved)}${solved ? "." : ", not by 0.6."}`}
    >
      <div class={layout["controls"]}>
        <SliderControl
          label="change of each shift"
          symbol="t"
          range={[0, 1.2]}
          step={0.01}
          value={shift}
          onChange={(next) => setShift(Number(next.toFixed(2)))}
        />
      </div>
    </Exercise>
  );
}
