import { fixed } from "#format/numbers";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { number } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import { bound } from "./collage";
import { Game, madeWords, useCollage, useMade } from "./game";

const PROMISE = 0.25;

/** The game with its number: the promise is to be brought down. */
export function Promise25() {
  const collage = useCollage("x1.copies");
  const made = useMade(collage.maps);
  const solved = collage.collage !== null && collage.most <= PROMISE;
  return (
    <Exercise
      number={1}
      ask="Cover the leaf so well that the promise is a quarter of its height or less: at most 0.25. Only then look at what the copies make."
      hints={[
        "Where it is worst stands a red line: at one end of it is a place that is not covered, or one that sticks out.",
        "Each of the three lobes of the leaf is a small leaf itself. Put a copy on each, turned by about 60 degrees at the sides.",
        "Sizes of 0.6 are large enough. Copy 1 at 0.68 up; copies 2 and 3 at 0.30 to the sides and 0.35 up; copy 4 small, in the middle.",
      ]}
      solved={solved}
      status={`The promise: what they make is at most ${fixed(collage.most)} off the leaf.`}
    >
      <Game collage={collage}>
        <p class="number">
          {`Collage ${fixed(collage.collage?.distance ?? 0)} off, largest copy ${fixed(collage.s)}: promise ${fixed(collage.collage?.distance ?? 0)} / (1 − ${fixed(collage.s)}) = ${fixed(collage.most)}. What they make is ${madeWords(made)} off.`}
        </p>
      </Game>
    </Exercise>
  );
}

const [OFF, LIMIT, LARGEST] = [0.06, 0.2, 0.7];

/** The promise read backwards. */
export function HowLarge() {
  const [s, setS] = useKept("x2.s", 0.5, number(0.1, 0.95, 2));
  const most = bound(OFF, s);
  const kept = most <= LIMIT + 1e-9;
  const solved = kept && s > LARGEST - 0.011;
  return (
    <Exercise
      number={2}
      ask="A collage is 0.06 off. You want to be sure that what it makes is at most 0.2 off. How large may the largest copy be, at most?"
      hints={[
        "0.06 / (1 − s) must not be more than 0.2.",
        "So 1 − s must be at least 0.06 / 0.2. How much is that?",
      ]}
      solved={solved}
      status={`0.06 / (1 − ${fixed(s)}) = ${fixed(most, 3)}${
        kept
          ? solved
            ? ": as large as may be."
            : ": sure enough, but it may be larger."
          : ": more than 0.2."
      }`}
    >
      <div class={layout["controls"]}>
        <SliderControl label="largest copy" symbol="s" range={[0.1, 0.95]} value={s} onChange={setS} />
      </div>
    </Exercise>
  );
}
