import { useContext, useMemo, useState } from "preact/hooks";
import { DEEPEST, newTarget } from "#geometry/maps/target";
import { gameOf } from "#ui/orbit/game";
import { TargetControls } from "#ui/orbit/TargetControls";
import { gameSpoken, MOST_THROWS, pointText } from "#ui/orbit/words";
import type { Heading } from "../../kit/frame/frame";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { HEIGHT } from "../../kit/maps/families";
import { tex } from "../../kit/notation/tex";
import { Page as Opened, useAfresh, useKept } from "../../kit/state/kept";
import { ChoiceQuestion } from "../frame/choice-question";
import { Lesson } from "../frame/lesson";
import { type Prediction, useChoice } from "../frame/prediction";
import { BOARD, HIDDEN, letters, lettersOf, MAPS, writtenAs } from "./cells";
import { Exercises } from "./exercises";
import { Field, useColours } from "./field";
import css from "./field.module.css";
import { Keyed } from "./keyed";
import { TEACHING } from "./teaching";

/** A game of throws that are chosen. */
export function Page(heading: Heading) {
  const prediction = useChoice<Order>(OPTIONS);
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            The chaos game without the dice: you choose each throw. One small cell of the gasket is framed.
            Bring the point into it in as few throws as you can.
          </p>
          <p>
            Press a number, its key, or a piece of the picture. The point jumps half of the way to that
            corner. To let others play for the same cell, press the link symbol at the top of this page: it
            copies a link with the target and without your throws.
          </p>
        </>
      }
      question={<Which prediction={prediction} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        { name: "A throw towards corner i", value: [tex`f_i(x) = \tfrac12 x + \tfrac12 c_i`] },
        { name: "Corners", symbol: tex`c_i`, value: "those of a triangle of side 1" },
        {
          name: "Cell of an address",
          value: [tex`A_{i_1 i_2 \dots i_n} = f_{i_1}(f_{i_2}(\dots f_{i_n}(A)))`],
        },
        { name: "First point", value: "the middle of the triangle, which is in no piece" },
      ]}
      sources={
        <p>
          The chaos game is Michael Barnsley’s (<cite>Fractals Everywhere</cite>, 1988), and addresses are
          John Hutchinson’s (1981). Robert Devaney of Boston University made a game of targets of it for
          schools.
        </p>
      }
      studio={{ href: studioHref({ a: preset("gasket"), b: preset("gasket") }) }}
    >
      <Play />
    </Lesson>
  );
}

const FIRST = "213";

function Play() {
  const [target, setTarget] = useKept("target", FIRST, HIDDEN);
  const page = useContext(Opened);
  // First links held the throws as well. Now they do not, so that whoever is sent one begins at the start.
  const [thrown, setThrown] = useAfresh(
    "throws",
    () => page.opened("throws", letters(0, MOST_THROWS)) ?? "",
    "",
  );
  const [shown, setShown] = useState(false);
  const throws = useMemo(() => lettersOf(thrown), [thrown]);
  const game = useMemo(
    () => gameOf(BOARD, { target: lettersOf(target), letters: throws, shown }),
    [target, throws, shown],
  );
  const set = (next: string, wasShown = false) => {
    setThrown(next);
    setShown(wasShown);
  };
  const throwTo = (letter: number) => {
    if (!game.reached && thrown.length < MOST_THROWS) set(`${thrown}${letter + 1}`);
  };
  const begin = (length: number) => {
    let next = target;
    for (let tries = 0; tries < 20 && next === target; tries++)
      next = writtenAs(newTarget(BOARD, length, Math.floor(Math.random() * 2 ** 31)));
    setTarget(next);
    set("");
  };
  return (
    <Keyed onMap={throwTo} onBack={() => set(thrown.slice(0, -1))} first>
      <Field
        label={`The gasket in a triangle 1 wide, with corner 1 at (0, 0), 2 at (1, 0) and 3 at ${pointText([0.5, HEIGHT])}. ${gameSpoken(game)}`}
        target={game.target}
        throws={throws}
        onPick={throwTo}
      />
      <div class={css["throws"]}>
        <TargetControls
          game={game}
          letters={throws}
          maps={MAPS.length}
          colours={useColours()}
          deepest={DEEPEST}
          onThrow={throwTo}
          onBack={() => set(thrown.slice(0, -1))}
          onAgain={() => set("")}
          onNew={begin}
          onShow={() => set(writtenAs(game.way), true)}
        />
      </div>
    </Keyed>
  );
}

const ASKED = lettersOf("132");
const ANSWER = lettersOf("231");
type Order = "forwards" | "backwards" | "any" | "place";
const OPTIONS = [
  {
    value: "forwards",
    label: "1, then 3, then 2",
    wrong:
      "The last throw decides in which large piece the point is. After these throws it is in piece 2, and the cell is in piece 1.",
  },
  { value: "backwards", label: "2, then 3, then 1" },
  {
    value: "any",
    label: "Any order of the three throws",
    wrong: "Each order ends with another throw or has another one before it, so it leads into another cell.",
  },
  {
    value: "place",
    label: "It depends on where the point is",
    wrong:
      "Three throws leave an eighth of what was before: wherever the point was, the same throws lead into the same cell.",
  },
] as const;

function Which({ prediction }: { prediction: Prediction<Order> }) {
  return (
    <ChoiceQuestion<Order>
      prediction={prediction}
      ask="The framed cell has the address 132: it is piece 2 of piece 3 of piece 1. Which throws lead into it?"
      options={OPTIONS}
      truth="backwards"
      beside={
        <Field
          label="The gasket with the cell 132 framed, at the lower left."
          target={ASKED}
          throws={prediction.shown ? ANSWER : []}
        />
      }
      line="2, then 3, then 1: the address, read backwards."
    >
      <p>
        The last throw takes the whole gasket to piece 1, so it is towards 1. Before it the point has to be
        where the cell lies within the whole, in piece 32: so the throw before is towards 3, and the first one
        towards 2.
      </p>
      <p>
        Each throw puts its number in front of the address. Two throws cannot be enough: from the start they
        lead to nine points, and none of them is in this cell.
      </p>
    </ChoiceQuestion>
  );
}
