import { useMemo, useState } from "preact/hooks";
import { Button } from "#ui/controls/Button";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { gasket } from "../../kit/maps/families";
import { tex } from "../../kit/notation/tex";
import { oneOf, whole } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { type Choice, Choices, Reply } from "../frame/choices";
import { Lesson, Question, Truth } from "../frame/lesson";
import lessonCss from "../frame/lesson.module.css";
import { type Prediction, usePrediction } from "../frame/prediction";
import { Board } from "./board";
import { Exercises } from "./exercises";
import css from "./page.module.css";
import { TEACHING } from "./teaching";
import { holes, Throws } from "./throws";

const FIRST = 5;
const MOST_THROWS = 20_000;
const MANY_THROWS = 10_000;
const NAMES = ["lower left", "lower right", "top"] as const;
type Where = "none" | "middle" | "edges";
const OPTIONS: readonly Choice<Where>[] = [
  {
    value: "none",
    label: "None: in the end there are marks all over it",
    wrong:
      "Chance chooses the corner, and no more: wherever one stands, a throw ends in one of the three half-size triangles.",
  },
  { value: "middle", label: "A triangle in the middle" },
  {
    value: "edges",
    label: "A strip along each of the three edges",
    wrong:
      "Marks come as near to an edge as you like: throw towards 1 and 2 only, above, and they creep along the bottom.",
  },
];

/** The chaos game, thrown by hand. */
export function Page(heading: Heading) {
  const prediction = usePrediction<Where>(null, oneOf(["none", "middle", "edges"]));
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            A game for one. There are three corners and a point. Throw a die to choose a corner, jump half of
            the way towards it, and leave a mark where you land. Then throw again from there.
          </p>
          <p>
            Five throws are on the board. Each mark has the colour of the corner that it was thrown towards.
            Make some throws of your own: press the buttons, a corner of the board, or the keys 1, 2 and 3.
          </p>
        </>
      }
      question={<Empty prediction={prediction} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        { name: "A throw towards corner i", value: [tex`f_i(x) = \tfrac12 x + \tfrac12 c_i`] },
        { name: "Corners", symbol: tex`c_i`, value: "those of a triangle of side 1" },
        { name: "First point", value: "the middle of the triangle" },
        { name: "Chance of each corner", value: "⅓" },
      ]}
      sources={
        <p>
          Michael Barnsley named it the chaos game, in <cite>Fractals Everywhere</cite> (1988). Burch and Hart
          draw their shapes with it, and so does the small picture of this lesson.
        </p>
      }
      studio={{
        href: studioHref({ a: preset("gasket"), b: { name: "Gasket, maps at 0.45", maps: gasket(0.45) } }),
      }}
    >
      <ByHand />
    </Lesson>
  );
}

function started(count: number): Throws {
  const game = new Throws();
  game.roll(count);
  return game;
}

function ByHand() {
  const [round, setRound] = useState({ game: started(FIRST) });
  const { game } = round;
  // The game is one object that moves on; a new round around it says so.
  const play = (act: (game: Throws) => void) => {
    if (game.count < MOST_THROWS) act(game);
    setRound({ game });
  };
  const last = game.corners.at(-1);
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: the keys are those of the buttons within
    <div
      class={`${layout["two-columns"]} ${layout["even"]}`}
      onKeyDown={(event) => {
        const corner = ["1", "2", "3"].indexOf(event.key);
        if (corner < 0 || event.ctrlKey || event.metaKey || event.altKey) return;
        event.preventDefault();
        play((now) => now.throwTo(corner));
      }}
    >
      <Board
        game={game}
        count={game.count}
        label={`The board after ${game.count} throws.`}
        onThrow={(corner) => play((now) => now.throwTo(corner))}
      />
      <div class={lessonCss["ask"]}>
        <div class={css["throwing"]}>
          <h2>Throw towards</h2>
          <div class={layout["buttons"]}>
            {NAMES.map((name, i) => (
              <Button key={name} description={name} onClick={() => play((now) => now.throwTo(i))}>
                {i + 1}, {name}
              </Button>
            ))}
          </div>
          <h2>Throw the die</h2>
          <div class={layout["buttons"]}>
            {[1, 10, 100].map((count) => (
              <Button
                key={count}
                onClick={() => play((now) => now.roll(count))}
                disabled={game.count >= MOST_THROWS}
              >
                {count === 1 ? "once" : `${count} times`}
              </Button>
            ))}
            <Button icon="reset" onClick={() => setRound({ game: started(0) })} disabled={game.count === 0}>
              Clear
            </Button>
          </div>
        </div>
        <p class="number" aria-live="polite">
          {game.count} throw{game.count === 1 ? "" : "s"}
          {last === undefined ? "" : `, the last towards ${last + 1}`}
        </p>
      </div>
    </div>
  );
}

function Empty({ prediction }: { prediction: Prediction<Where> }) {
  const { shown } = prediction;
  const [count, setCount] = useKept("throws", MANY_THROWS, whole(1, MANY_THROWS));
  const game = useMemo(() => started(shown ? count : 0), [shown, count]);
  const hatched = useMemo(() => (shown ? holes(3) : []), [shown]);
  return (
    <Question
      prediction={prediction}
      truth="middle"
      beside={
        <Board
          game={game}
          count={game.count}
          holes={hatched}
          label={
            shown
              ? `${count} throws: they fill Sierpinski’s gasket. The middle triangle is empty, and so are the middles of the halves, and theirs.`
              : "An empty board with three corners."
          }
        />
      }
      answer={
        <Truth line={`Of ${groups(count)} throws, ${game.inMiddle} fell into the middle triangle.`}>
          <Reply options={OPTIONS} prediction={prediction} truth="middle" />
          <p>
            A throw halves the way to a corner, so it ends in the half-size triangle at that corner. The
            middle triangle is in none of the three. And what holds of the whole holds of each half: its own
            middle stays empty, and so on down. What is left is the gasket.
          </p>
          <p>
            The point begins in the middle, and leaves it for good with the first throw. After that it is in a
            hole of half the size each time: it never quite reaches the gasket, but soon nobody can tell.
          </p>
          <div class={layout["buttons"]}>
            {[10, 100, 1000, MANY_THROWS].map((many) => (
              <Button key={many} pressed={many === count} onClick={() => setCount(many)}>
                {groups(many)}
              </Button>
            ))}
          </div>
        </Truth>
      }
    >
      <Choices<Where>
        ask="Now somebody throws ten thousand times. Which part of the triangle stays empty?"
        options={OPTIONS}
        prediction={prediction}
        truth="middle"
      />
    </Question>
  );
}

/** 10 000 with a thin space. */
function groups(count: number): string {
  return count >= 10_000
    ? `${Math.floor(count / 1000)} ${String(count % 1000).padStart(3, "0")}`
    : String(count);
}
