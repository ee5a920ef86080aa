import { fixed } from "#format/numbers";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { number, whole } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";

export function Exercises() {
  return (
    <>
      <Times />
      <Largest />
    </>
  );
}

/** A picture of black and white points, in bytes, and the leaf: a digit takes four bits. */
const PICTURE = (300 * 300) / 8;
const DIGITS = 72;
const LEAF_BYTES = DIGITS / 2;
const TIMES = PICTURE / LEAF_BYTES;

function Times() {
  const [bytes, setBytes] = useKept("x1.bytes", 100, whole(1, 200));
  const solved = bytes === LEAF_BYTES;
  return (
    <Exercise
      number={1}
      ask={`A picture of 300 by 300 points, black or white, takes ${PICTURE.toLocaleString("en")} bytes: a byte is eight points. The leaf is ${DIGITS} digits, and two digits fit into a byte. How many bytes is the leaf?`}
      hints={[
        "One digit takes half a byte.",
        `So take half of ${DIGITS}. Signs and the point would need a few bytes more.`,
      ]}
      solved={solved}
      status={`The picture would be ${fixed(PICTURE / bytes, 0)} times as long.${
        solved ? ` So the leaf is more than ${Math.floor(TIMES / 10) * 10} times shorter.` : ""
      }`}
    >
      <div class={layout["controls"]}>
        <SliderControl label="bytes" range={[1, 200]} whole value={bytes} onChange={setBytes} />
      </div>
    </Exercise>
  );
}

const [MOVED, WANTED] = [0.003, 0.01];

/** The promise read backwards. */
function Largest() {
  const [s, setS] = useKept("x2.s", 0.5, number(0.1, 0.95, 2));
  const most = MOVED / (1 - s);
  const holds = most <= WANTED + 1e-12;
  const solved = holds && MOVED / (1 - s - 0.01) > WANTED;
  return (
    <Exercise
      number={2}
      ask={`Rounding moves what each map makes of a point by ${MOVED} at most. How large may the largest copy be, at most, if the leaf is to be within ${WANTED}? Find the largest with two digits after the point.`}
      hints={[
        `${MOVED} / (1 − s) must not be more than ${WANTED}.`,
        `So 1 − s must be at least ${MOVED} / ${WANTED}.`,
      ]}
      solved={solved}
      status={`${MOVED} / (1 − ${fixed(s)}) = ${fixed(most, 4)}${
        holds ? (solved ? ": as large as may be." : ": near enough, but it may be larger.") : ": too far."
      }`}
    >
      <div class={layout["controls"]}>
        <SliderControl
          label="largest copy"
          symbol="s"
          range={[0.1, 0.95]}
          step={0.01}
          value={s}
          onChange={(next) => setS(Number(next.toFixed(2)))}
        />
      </div>
    </Exercise>
  );
}
