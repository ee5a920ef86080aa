import { fixed } from "#format/numbers";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { number } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import { Line } from "./line";

export function Exercises() {
  return (
    <>
      <Halved />
      <Resting />
    </>
  );
}

const STEPS = 10;
/** The largest hundredth that halves within so many steps. */
const LARGEST = 0.93;

function Halved() {
  const [scale, setScale] = useKept("x1.scale", 0.8, number(0.5, 1, 2));
  const left = scale ** STEPS;
  const solved = Math.abs(scale - LARGEST) < 1e-9;
  return (
    <Exercise
      number={1}
      ask={`After ${STEPS} steps two points are to be less than half as far apart as they were. How large may the scale be? Find the largest with two digits after the point.`}
      hints={[
        "With scale 0.8 a tenth is left. That is far less than half: the scale may be larger.",
        "It is between 0.9 and 0.95.",
      ]}
      solved={solved}
      status={`${fixed(scale)} to the power of ${STEPS} is ${fixed(left, 3)}${
        left >= 0.5
          ? ": more than half is left."
          : solved
            ? ", and 0.94 is too large."
            : ": the scale may be larger."
      }`}
    >
      <div class={layout["controls"]}>
        <SliderControl
          label="scale"
          symbol="s"
          range={[0.5, 1]}
          value={scale}
          onChange={(next) => setScale(Number(next.toFixed(2)))}
        />
      </div>
    </Exercise>
  );
}

/** The point that halving and adding 3 leaves in place. */
const HOME = 6;
const next = (x: number) => x / 2 + 3;
/** Once it is found, both ends of the ruler are followed to it. */
const ENDS = [0, 10];
const MANY = 8;

function Resting() {
  const [x, setX] = useKept("x2.point", 0, number(0, 10, 1));
  const solved = Math.abs(x - HOME) < 1e-9;
  return (
    <Exercise
      number={2}
      ask="On a ruler a map takes half of each number and adds 3. So 0 goes to 3, and 10 goes to 8. One number stays where it is. Which?"
      hints={[
        "Follow any number: 0 goes to 3, then to 4.5, then to 5.25. Where does that lead?",
        "If it stays, one half of it must be the 3 that is added.",
      ]}
      solved={solved}
      status={
        solved
          ? "Half of 6 is 3, and 3 + 3 is 6. All other numbers come to it, step by step."
          : `${x} goes to ${next(x)}.`
      }
    >
      <Line from={solved ? ENDS : [x]} map={next} steps={solved ? MANY : 1} />
      <div class={layout["controls"]}>
        <SliderControl
          label="number"
          range={[0, 10]}
          step={0.5}
          value={x}
          text={String(x)}
          onChange={(to) => setX(Number(to.toFixed(1)))}
        />
      </div>
    </Exercise>
  );
}
