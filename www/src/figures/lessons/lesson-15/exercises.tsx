import { useMemo } from "preact/hooks";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { gasket } from "../../kit/maps/families";
import { apply, compose, type Point } from "../../kit/maps/pieces";
import type { Place } from "../../kit/picture/annotated";
import { number } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import lessonCss from "../frame/lesson.module.css";
import { CORNERS } from "../lesson-2/throws";
import { play, share } from "./dice";
import css from "./page.module.css";
import { Shade } from "./shade";
import { CUT, CUT_BOX, FOOT, TOP, TRIANGLE } from "./shapes";
import { percent, useWeights, Weights } from "./weights";

const MAPS = gasket(0.5);
const MANY = 60_000;
/** Piece 3, and piece 1 of piece 2. */
const PIECES = [[2], [1, 0]] as const;
const WANTED = [
  { chance: 0.5, off: 0.01 },
  { chance: 0.06, off: 0.002 },
] as const;

/** A die that gives two pieces what is asked. */
export function Shares() {
  const die = useWeights("x1.weights", [0.5, 0.5, 0.5]);
  const game = useMemo(() => play(MAPS, die.weights, MANY), [die.weights]);
  const [top, small] = PIECES.map((address) => share(die.weights, address));
  const right = [top, small].map((is = 0, i) => {
    const { chance, off } = WANTED[i] ?? { chance: 0, off: 0 };
    return Math.abs(is - chance) <= off + 1e-9;
  });
  const said = `Piece 3 gets ${percent(top ?? 0)} throws, and piece 1 of piece 2 gets ${percent(small ?? 0)}.`;
  return (
    <Exercise
      number={1}
      ask="Choose the weights so that half of all throws land in piece 3, and 6 of 100 in piece 1 of piece 2, the small triangle that is framed."
      hints={[
        "A throw lands in piece 1 of piece 2 if face 1 comes first and face 2 right after it. Both chances multiply.",
        "The chances of faces 1 and 2 are two numbers with sum 0.5 and product 0.06.",
        "0.2 and 0.3 are such numbers. With 1 for face 3 the weights are twice the chances.",
      ]}
      solved={right.every(Boolean)}
      status={said}
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Shade game={game} box={TRIANGLE} label={`The gasket, shaded by marks. ${said}`}>
          {(place) =>
            PIECES.map((address) => <Outline key={address.join()} address={address} place={place} />)
          }
        </Shade>
        <div class={lessonCss["ask"]}>
          <Weights of={die} />
        </div>
      </div>
    </Exercise>
  );
}

/** The triangle of a piece. */
function Outline({ address, place }: { address: readonly number[]; place: Place }) {
  const corners = CORNERS.map((corner): Point => {
    const map = address.map((letter) => MAPS[letter] ?? CUT[0]).reduce((p, q) => p && q && compose(p, q));
    return map ? apply(map, corner) : corner;
  });
  return <path class={css["frame"]} d={`M${corners.map((p) => place(p).join(" ")).join("L")}Z`} />;
}

const RIGHT = 0.36;

/** A triangle of two unequal pieces, to be shaded evenly. */
export function Evenly() {
  const [chance, setChance] = useKept("x2.chance", 0.6, number(0.05, 0.95, 2));
  const game = useMemo(() => play(CUT, [chance, 1 - chance], 2 * MANY), [chance]);
  const solved = Math.abs(chance - RIGHT) < 0.0101;
  const said = solved
    ? "The shade is even, or too nearly so to be told by eye."
    : `The ${chance > RIGHT ? "left" : "right"} piece gets more marks than its size asks for.`;
  return (
    <Exercise
      number={2}
      ask="The height of this right triangle cuts it into two triangles of its own shape. The left one has sides of 0.6 of the whole, the right one of 0.8. Which chance for the left one makes the shade even all over?"
      hints={[
        "It is even if each piece gets a share of the marks that is as large as its share of the area.",
        "Half as long a side means a quarter of the area. What do sides of 0.6 mean?",
      ]}
      solved={solved}
      status={said}
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Shade
          game={game}
          box={CUT_BOX}
          shape={2}
          grain={3}
          label={`A right triangle, shaded by marks. ${said}`}
        >
          {(place) => <path class={css["frame"]} d={`M${place(TOP).join(" ")}L${place(FOOT).join(" ")}`} />}
        </Shade>
        <div class={lessonCss["ask"]}>
          <SliderControl
            label="chance of the left piece"
            range={[0.05, 0.95]}
            value={chance}
            onChange={setChance}
          />
        </div>
      </div>
    </Exercise>
  );
}
