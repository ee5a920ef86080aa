import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import type { Box } from "#document/framing";
import { reducedMotion } from "#document/preferences";
import { Button } from "#ui/controls/Button";
import { PlayButton } from "#ui/strip/PlayButton";
import { Choice, SliderControl } from "../../kit/frame/control";
import { Formula } from "../../kit/frame/formula";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { gasket, HEIGHT } from "../../kit/maps/families";
import { copies, STARTS } from "../../kit/maps/iterates";
import { apply, type Point } from "../../kit/maps/pieces";
import { tex } from "../../kit/notation/tex";
import { Iterates, type Start } from "../../kit/picture/iterates";
import { oneOf, whole } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { usePlay } from "../../kit/time/play";
import { ChoiceQuestion } from "../frame/choice-question";
import { Exercise } from "../frame/exercise";
import { Lesson } from "../frame/lesson";
import lessonCss from "../frame/lesson.module.css";
import { type Prediction, useChoice } from "../frame/prediction";
import css from "./page.module.css";
import { squarePicture } from "./photograph";
import { TEACHING } from "./teaching";

const MAPS = gasket(0.5);
const BOX: Box = { x0: 0, y0: 0, x1: 1, y1: 1 };
const MOST = 8;
/** So far the film goes before there is a prediction: its answer is not to be seen on it. */
const BEFORE = 3;
/** Steps a second while it plays. */
const PACE = 1.25;

type Name = keyof typeof STARTS | "own";
const NAMES = [
  { value: "letter", label: "letter F" },
  { value: "square", label: "square" },
  { value: "dot", label: "dot" },
] as const;
const START_OF: Record<keyof typeof STARTS, Start> = {
  letter: { outlines: STARTS.letter },
  square: { outlines: STARTS.square },
  dot: { outlines: STARTS.dot },
};

/** Hutchinson's theorem, seen. */
export function Page(heading: Heading) {
  const prediction = useChoice<Left>(OPTIONS);
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            Take any figure. Make three copies of it, each half as large, and put them into the three corners
            of a triangle: that is one step. Now take all that there is and do the same again.
          </p>
          <p data-screen="">
            Play the steps, stop them, drag them. Then start from something else: even from a picture of your
            own.
          </p>
        </>
      }
      question={<Difference prediction={prediction} />}
      exercises={
        <>
          <HowMany />
          <Unchanged />
        </>
      }
      teaching={TEACHING}
      parameters={[
        {
          name: "Maps, towards the corners of a triangle of side 1",
          value: [tex`f_i(x) = \frac{1}{2} x + \frac{1}{2} c_i`],
        },
        { name: "One step", value: [tex`F(B) = f_1(B) \cup f_2(B) \cup f_3(B)`] },
        { name: "Steps", symbol: "n", value: `0 to ${MOST}` },
      ]}
      sources={
        <p>
          John Hutchinson proved in 1981 (<cite>Fractals and self similarity</cite>) that finitely many maps,
          each of which shrinks all distances by a factor below 1, have exactly one bounded and closed figure
          with at least one point that a step leaves as it is, and that every other such figure comes nearer
          to it with every step. It is called their attractor.
        </p>
      }
      studio={{ href: studioHref({ a: preset("gasket"), b: preset("tree") }) }}
    >
      <Film most={prediction.shown ? MOST : BEFORE} />
    </Lesson>
  );
}

const stepsWords = (steps: number) => `${steps} step${steps === 1 ? "" : "s"}`;

/** Steps that play, once by themselves unless less motion is wanted. */
function useSteps(most: number) {
  const [time, setTime] = useKept("step", 0, whole(0, MOST));
  const player = usePlay((seconds) => {
    const next = Math.min(most, time + PACE * seconds);
    setTime(next);
    return next < most;
  });
  const toggle = () => {
    if (!player.playing && time >= most) setTime(0);
    player.toggle();
  };
  const begun = useRef(false);
  useEffect(() => {
    if (begun.current || reducedMotion.peek()) return;
    begun.current = true;
    toggle();
  });
  const go = (steps: number) => {
    player.stop();
    setTime(steps);
  };
  return { steps: Math.floor(Math.min(most, time) + 1e-9), playing: player.playing, toggle, go };
}

function Film({ most }: { most: number }) {
  const { steps, playing, toggle, go } = useSteps(most);
  const [name, setName] = useKept<Name>("start", "letter", oneOf(NAMES.map(({ value }) => value)));
  const [own, setOwn] = useState<ImageBitmap | null>(null);
  const [problem, setProblem] = useState("");
  const start = name === "own" ? own && { picture: own } : START_OF[name];
  const file = useRef<HTMLInputElement>(null);
  useEffect(() => () => own?.close(), [own]);

  const take = async (chosen: File | undefined) => {
    if (!chosen) return;
    try {
      setOwn(await squarePicture(chosen));
      setName("own");
      setProblem("");
      go(0);
    } catch {
      setProblem(`${chosen.name} is no picture that this browser can read. Try a PNG or a JPEG.`);
    }
  };

  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <Iterates
        maps={MAPS}
        steps={steps}
        start={start ?? START_OF.letter}
        box={BOX}
        label={
          steps === 0
            ? "The start."
            : `After ${stepsWords(steps)}: ${3 ** steps} copies of the start, each ${2 ** steps} times smaller.`
        }
      />
      <div class={lessonCss["ask"]}>
        <Choice
          label="Start from"
          name="What to start from"
          options={own ? [...NAMES, { value: "own", label: "your picture" }] : NAMES}
          value={name}
          onChange={(next: Name) => setName(next)}
        />
        <div class={layout["buttons"]}>
          <Button icon="open" onClick={() => file.current?.click()}>
            A picture of yours
          </Button>
          <span class={layout["hint"]} data-screen="">
            It stays on this device.
          </span>
          <input
            ref={file}
            class={css["file"]}
            type="file"
            accept="image/png,image/jpeg,image/webp,image/gif,image/avif"
            tabIndex={-1}
            aria-label="A picture of yours"
            onChange={(event) => {
              take(event.currentTarget.files?.[0]);
              event.currentTarget.value = "";
            }}
          />
        </div>
        {problem !== "" && (
          <p role="alert" class={layout["missing"]}>
            {problem}
          </p>
        )}
        <div class={css["play"]}>
          <PlayButton playing={playing} onToggle={toggle} />
          <SliderControl label="steps" symbol="n" range={[0, most]} whole value={steps} onChange={go} />
        </div>
        <p class="number" aria-live={playing ? "off" : "polite"}>
          {3 ** steps} {steps === 0 ? "figure" : "copies"},{" "}
          {2 ** steps === 1 ? "as large as it is" : `${2 ** steps} times smaller`}
        </p>
        <p class={layout["hint"]} data-screen="">
          {most < MOST
            ? `Once you have guessed, below, it goes on to ${MOST}.`
            : `It goes on to ${MOST} now.`}
        </p>
      </div>
    </div>
  );
}

type Left = "all" | "half" | "hardly";
const OPTIONS = [
  {
    value: "all",
    label: "All of it: from a square and from a dot come different shapes",
    wrong: "Drag the steps below: each halves every copy, and with it what tells a square from a dot.",
  },
  {
    value: "half",
    label: "Half of it: the shapes are alike, but one is clearly thicker",
    wrong: "It is half after one step. Drag the steps below and see what the others leave of it.",
  },
  { value: "hardly", label: "Hardly anything: one could not tell which start it was" },
] as const;

function Difference({ prediction }: { prediction: Prediction<Left> }) {
  return (
    <ChoiceQuestion<Left>
      prediction={prediction}
      ask="Somebody starts from a big square, somebody else from a tiny dot. After eight steps, how much is left of the difference?"
      options={OPTIONS}
      truth="hardly"
      after={<Beside />}
      line={`After eight steps ${2 ** MOST} times less than at the start.`}
    >
      <p>
        How far apart are two figures? Look for the point of either that is farthest from the other one, and
        measure that distance. A step halves all distances, so afterwards they are at most half as far apart,
        after <Formula>n</Formula> steps at most <Formula tex={tex`1 / 2^n`} /> of it. Whatever one starts
        from, all come to the same shape. It belongs to the maps alone, and is the only one that a step leaves
        as it is. This one is called a gasket: that of Wacław Sierpiński, who described it in 1915.
      </p>
    </ChoiceQuestion>
  );
}

/** Two starts side by side. */
function Beside() {
  const [steps, setSteps] = useKept("beside", 0, whole(0, MOST));
  return (
    <>
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        {(["square", "dot"] as const).map((name) => (
          <Panel key={name} caption={`from a ${name}`}>
            <Iterates
              maps={MAPS}
              steps={steps}
              start={START_OF[name]}
              box={BOX}
              label={`From a ${name}, after ${stepsWords(steps)}.`}
            />
          </Panel>
        ))}
      </div>
      <div class={layout["controls"]}>
        <SliderControl
          label="steps"
          symbol="n"
          range={[0, MOST]}
          whole
          value={steps}
          valueText={`${stepsWords(steps)}: at most 1/${2 ** steps} of the difference`}
          text={`${steps}, at most 1/${2 ** steps} of the difference`}
          onChange={setSteps}
        />
      </div>
    </>
  );
}

function HowMany() {
  const [steps, setSteps] = useKept("x1.steps", 2, whole(0, 20));
  return (
    <Exercise
      number={1}
      ask="Two figures are 1 apart, as far as the triangle is wide. After how many steps are they surely nearer than 1/1000, whatever they look like? Find the least number."
      hints={[
        "After n steps they are at most 1 / 2ⁿ apart.",
        "2 · 2 · 2 … : which power of 2 is the first above 1000?",
      ]}
      solved={steps === 10}
      status={`After ${stepsWords(steps)} they are at most 1/${2 ** steps} apart${
        steps > 10 ? ": near enough, but fewer steps would do" : steps < 10 ? ": still too far" : ""
      }.`}
    >
      <div class={layout["controls"]}>
        <SliderControl label="steps" symbol="n" range={[0, 20]} whole value={steps} onChange={setSteps} />
      </div>
    </Exercise>
  );
}

type Kept = "square" | "full" | "frame" | "gasket";
const TRIANGLE: readonly Point[] = [
  [0, 0],
  [1, 0],
  [0.5, HEIGHT],
];
const KEPT = [
  { value: "square", label: "square" },
  { value: "full", label: "full triangle" },
  { value: "frame", label: "its edge" },
  { value: "gasket", label: "gasket" },
] as const;
const KEPT_WORDS: Record<Kept, string> = {
  square: "It becomes three squares.",
  full: "A hole comes into its middle.",
  frame: "The edge stays, and lines come into the middle.",
  gasket: "Each corner of it is a half-size gasket already: the three copies are the whole again.",
};

/** The edge of the triangle: four sides of each, thin. */
function edges(): Point[][] {
  const middle: Point = [0.5, HEIGHT / 3];
  const inner = TRIANGLE.map(
    ([x, y]): Point => [middle[0] + 0.94 * (x - middle[0]), middle[1] + 0.94 * (y - middle[1])],
  );
  return TRIANGLE.map((corner, i) => {
    const next = (i + 1) % 3;
    return [corner, TRIANGLE[next] ?? corner, inner[next] ?? corner, inner[i] ?? corner];
  });
}

function Unchanged() {
  const [name, setName] = useKept<Kept>("x2.start", "full", oneOf(KEPT.map(({ value }) => value)));
  const start = useMemo<Start>(() => {
    if (name === "square") return START_OF.square;
    if (name === "full") return { outlines: [TRIANGLE] };
    if (name === "frame") return { outlines: edges() };
    return { outlines: copies(MAPS, 7).map(({ map }) => TRIANGLE.map((corner) => apply(map, corner))) };
  }, [name]);
  return (
    <Exercise
      number={2}
      ask="Which of these starts is the same after a step as before?"
      hints={["What a step leaves as it is must be made of three half-size copies of itself already."]}
      solved={name === "gasket"}
      status={KEPT_WORDS[name]}
    >
      <Choice
        label="Start from"
        name="Which start"
        options={KEPT}
        value={name}
        onChange={(next: Kept) => setName(next)}
      />
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        {[0, 1].map((steps) => (
          <Panel key={steps} caption={steps === 0 ? "before" : "after a step"}>
            <Iterates
              maps={MAPS}
              steps={steps}
              start={start}
              box={BOX}
              label={`${steps === 0 ? "Before" : "After"} a step: ${KEPT_WORDS[name]}`}
            />
          </Panel>
        ))}
      </div>
    </Exercise>
  );
}
