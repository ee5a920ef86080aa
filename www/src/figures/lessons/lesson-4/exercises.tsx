import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { barnsley } from "../../kit/connectedness/barnsley";
import { Rows } from "../../kit/connectedness/barnsley-rows";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { number, whole } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";

const MOST = 11;
const WANTED = 4;

export function Exercises() {
  return (
    <>
      <AfterFour />
      <ByTheGap />
    </>
  );
}

/** A dust that takes so many steps and no fewer. */
function AfterFour() {
  const [r, setR] = useKept("x1.r", 0.42, number(0.3, 0.5, 3));
  const rounds = useMemo(() => barnsley(r, MOST), [r]);
  const last = rounds.at(-1);
  const n = last?.apart ? last.n : null;
  return (
    <Exercise
      number={1}
      ask={`Choose r so that the test proves the pieces apart at n = ${WANTED}, and not earlier.`}
      hints={[
        "The narrower the gap, the more steps it takes. Is n too small or too large now?",
        "At 0.45 it takes 2 steps, at 0.49 it takes 5.",
      ]}
      solved={n === WANTED}
      status={n === null ? `Not proved in ${MOST} steps.` : `At r = ${fixed(r, 3)} it is proved at n = ${n}.`}
    >
      <Rows rounds={rounds.slice(0, WANTED + 1)} r={r} />
      <div class={layout["controls"]}>
        <SliderControl
          label="scale"
          symbol="r"
          range={[0.3, 0.5]}
          step={0.005}
          value={r}
          text={fixed(r, 3)}
          onChange={(next) => setR(Number(next.toFixed(3)))}
        />
      </div>
    </Exercise>
  );
}

const R = 0.48;

/** What can be said beforehand: the distance is never less than the gap. */
function ByTheGap() {
  const [n, setN] = useKept("x2.n", 1, whole(0, MOST - 1));
  const gap = 1 - 2 * R;
  const bound = 2 * R ** (n + 1);
  const before = 2 * R ** n;
  const solved = bound < gap && before >= gap;
  return (
    <Exercise
      number={2}
      ask={`Now r = ${R}, and the gap is ${fixed(gap)}. The distance that is measured is never less than the gap. So at which n are the pieces surely proved apart, whatever is measured? Find the least.`}
      hints={[
        "It is surely proved once the bound 2rⁿ⁺¹ is less than the gap.",
        `So ${R} to the power of n + 1 has to be less than 0.02. Multiply ${R} by itself until it is.`,
      ]}
      solved={solved}
      status={`2 · ${R} to the power of ${n + 1} is ${bound.toFixed(4)}${
        solved
          ? ": the first below the gap. The test may end sooner, because the distance is more than the gap."
          : bound < gap
            ? ": below the gap, but it was so before."
            : ": not below the gap yet."
      }`}
    >
      <div class={layout["controls"]}>
        <SliderControl label="step" symbol="n" range={[0, MOST - 1]} whole value={n} onChange={setN} />
      </div>
    </Exercise>
  );
}
