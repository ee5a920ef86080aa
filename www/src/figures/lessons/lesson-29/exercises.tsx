import { fixed } from "#format/numbers";
import layout from "../../kit/frame/layout.module.css";
import { number } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import { Curve } from "../lesson-18/curve";
import { dimension } from "../lesson-18/rough";
import { Copies } from "./copies";
import { isHalfWay, LEVEL, MOST, quarter, tent } from "./hill";

export function Exercises() {
  return (
    <>
      <Plateau />
      <HalfWay />
    </>
  );
}

/** As high over a quarter as in the middle. */
function Plateau() {
  const [s, setS] = useKept("x1.s", 0.2, number(0, MOST, 2));
  return (
    <Exercise
      number={1}
      ask="In the middle the curve is 1 high, whatever s is. Choose s so that over ¼ it is exactly as high as in the middle."
      hints={[
        "Over ¼ the tent is ½ high. The copy that stands there adds its own middle.",
        "The middle of the copy is s high: so ½ + s must be 1.",
      ]}
      solved={s === LEVEL}
      status={`Over ¼ it is ${fixed(quarter(s))} high, in the middle 1.`}
    >
      <Setting s={s} onChange={setS} />
    </Exercise>
  );
}

function HalfWay() {
  const [s, setS] = useKept("x2.s", 0.5, number(0, MOST, 2));
  return (
    <Exercise
      number={2}
      ask="Beyond ½ the curve is more than a line. Choose s so that its dimension is 1.5, half-way between a line and an area, to two digits."
      hints={[
        "With two pieces the dimension is 1 + log(2s) / log 2, as How rough is a curve? found.",
        "So 2s must be the square root of 2.",
      ]}
      solved={isHalfWay(s)}
      status={`2s is ${fixed(2 * s)}: dimension ${fixed(dimension(tent(s)), 3)}.`}
    >
      <Setting s={s} onChange={setS} />
    </Exercise>
  );
}

function Setting({ s, onChange }: { s: number; onChange: (s: number) => void }) {
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <Curve
        curve={tent(s)}
        label={`The curve over three points whose copies are ${fixed(s)} times as tall.`}
      />
      <Copies value={s} onChange={onChange} />
    </div>
  );
}
