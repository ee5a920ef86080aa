import { useMemo } from "preact/hooks";
import type { Box } from "#document/framing";
import { fixed } from "#format/numbers";
import { Plot } from "../../kit/chart/plot";
import { Choice, SliderControl } from "../../kit/frame/control";
import { Formula } from "../../kit/frame/formula";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { EXACT, VerdictChip } from "../../kit/frame/verdict";
import { dust, gasket, HEIGHT } from "../../kit/maps/families";
import { copies } from "../../kit/maps/iterates";
import { tex } from "../../kit/notation/tex";
import { Drawn } from "../../kit/picture/annotated";
import { Picture } from "../../kit/picture/picture";
import { number, oneOf, whole } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { useVerdict } from "../../kit/workers";
import { ChoiceQuestion } from "../frame/choice-question";
import { Exercise } from "../frame/exercise";
import { Lesson } from "../frame/lesson";
import lessonCss from "../frame/lesson.module.css";
import { type Prediction, useChoice } from "../frame/prediction";
import { boxesOf, GRIDDED, moran } from "./boxes";
import { Counted } from "./counted";
import { TooMuch } from "./overlap";
import css from "./page.module.css";
import { TEACHING } from "./teaching";

type Name = keyof typeof GRIDDED;
const UNIT: Box = { x0: 0, y0: 0, x1: 1, y1: 1 };
const NAMES: Record<Name, string> = { line: "line", square: "square", gasket: "gasket", carpet: "carpet" };
const option = (value: Name) => ({ value, label: NAMES[value] });

/** Dimension, by boxes. */
export function Page(heading: Heading) {
  const prediction = useChoice<Times>(OPTIONS);
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            Lay a grid over a shape and count the boxes that hold some of it. Then make the boxes half as
            wide. A line needs twice as many now, a square four times as many. Try it.
          </p>
          <p>
            2 is 2 to the power of 1, and 4 is 2 to the power of 2. That 1 and 2 is what one means by the{" "}
            <em>dimension</em> of a line and of a square.
          </p>
        </>
      }
      question={<HowMany prediction={prediction} />}
      exercises={
        <>
          <HalfDust />
          <Roomy />
        </>
      }
      teaching={TEACHING}
      parameters={[
        { name: "Boxes of side", symbol: "s", value: "½, ¼, … ; for the carpet ⅓, ⅑, …" },
        { name: "Boxes counted", symbol: tex`N(s)`, value: "that hold more than a part of their edge" },
        { name: "Dimension", symbol: "D", value: [tex`N(s)`, " grows as ", tex`(1/s)^D`] },
        {
          name: "Moran’s equation for scales",
          symbol: tex`r_i`,
          value: [tex`r_1^D + r_2^D + \dots + r_N^D = 1`],
        },
      ]}
      sources={
        <p>
          P. A. P. Moran proved in 1946 that his equation gives the Hausdorff dimension of a shape whose maps
          are similarities and whose pieces do not overlap in this sense: some open set, bounded and not
          empty, holds its copies, and the copies have no point in common. Counting boxes gives the same
          number for such shapes (Kenneth Falconer, <cite>Fractal Geometry</cite>, 1990). Without that
          condition it is an upper bound.
        </p>
      }
      studio={{ href: studioHref({ a: preset("gasket"), b: preset("carpet") }) }}
    >
      <Counting as="shape" names={["line", "square"]} />
    </Lesson>
  );
}

/** A shape under its boxes. */
function Boxed({ name, level }: { name: Name; level: number }) {
  const shape = GRIDDED[name];
  const boxes = useMemo(() => boxesOf(shape, level), [shape, level]);
  const side = 1 / shape.base ** Math.min(level, shape.most);
  return (
    <Drawn
      maps={shape.maps}
      box={UNIT}
      label={`The ${NAMES[name]} under boxes of side ${sideWords(shape.base, level)}: ${boxes.length} of them hold some of it.`}
    >
      {(place) => <Counted boxes={boxes} side={side} place={place} />}
    </Drawn>
  );
}

const sideWords = (base: number, level: number) => (level === 0 ? "1" : `1/${base ** level}`);

/** `as` is its name in the address of the lesson. */
function Counting({ names, as }: { names: readonly Name[]; as: string }) {
  const [name, setName] = useKept<Name>(as, names[0] ?? "line", oneOf(names));
  const [level, setLevel] = useKept(`${as}.level`, 1, whole(0, 12));
  const shape = GRIDDED[name];
  const at = Math.min(level, shape.most);
  const count = useMemo(() => boxesOf(shape, at).length, [shape, at]);
  const before = useMemo(() => (at === 0 ? null : boxesOf(shape, at - 1).length), [shape, at]);
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <Boxed name={name} level={at} />
      <div class={lessonCss["ask"]}>
        <Choice
          label="Shape"
          options={names.map(option)}
          value={name}
          onChange={(next: Name) => setName(next)}
        />
        <SliderControl
          label="how fine"
          symbol="n"
          range={[0, shape.most]}
          whole
          value={at}
          text={`boxes of side ${sideWords(shape.base, at)}`}
          onChange={setLevel}
        />
        <p class="number" aria-live="polite">
          {count} box{count === 1 ? "" : "es"}
          {before === null
            ? ""
            : `: ${count / before} times as many as at the step before, whose boxes are ${shape.base} times as wide`}
        </p>
        <Slopes names={names} now={{ name, level: at }} />
      </div>
    </div>
  );
}

const COLOURS: Record<Name, number> = { line: 0, square: 1, gasket: 2, carpet: 3 };

/** How the counts grow: straight lines, the steeper the higher the dimension. */
function Slopes({ names, now }: { names: readonly Name[]; now: { name: Name; level: number } }) {
  const points = (name: Name) => {
    const { base, most } = GRIDDED[name];
    return Array.from({ length: most + 1 }, (_, n): [number, number] => [
      n * Math.log2(base),
      Math.log2(boxesOf(GRIDDED[name], n).length),
    ]);
  };
  const power = (value: number) => String(2 ** value);
  return (
    <Plot
      label={`Boxes against their fineness, both doubling: ${names.map((name) => `the ${NAMES[name]} has slope ${fixed(moran(GRIDDED[name].maps.map(([a]) => a)), 3)}`).join(", ")}.`}
      x={{ min: 0, max: 6, ticks: [0, 2, 4, 6], format: power, name: "1/s" }}
      y={{ min: 0, max: 10, ticks: [0, 2, 4, 6, 8, 10], format: power, name: "boxes" }}
      series={names.map((name) => ({
        name: NAMES[name],
        points: points(name),
        colour: COLOURS[name],
        dots: true,
      }))}
      now={now.level * Math.log2(GRIDDED[now.name].base)}
    />
  );
}

type Times = "2" | "3" | "4" | "grows";
const OPTIONS = [
  {
    value: "2",
    label: "Twice as many, as for a line",
    wrong:
      "It is not a line: at each step the gasket goes two ways from a box. Count the filled boxes below.",
  },
  { value: "3", label: "Three times as many" },
  {
    value: "4",
    label: "Four times as many, as for a square",
    wrong: "Of the four quarters of a box one stays empty, the one at its upper right. Count below.",
  },
  {
    value: "grows",
    label: "At first three times, then more and more",
    wrong: "Every box looks like the whole, only smaller: so each step is like the first. Count below.",
  },
] as const;

function HowMany({ prediction }: { prediction: Prediction<Times> }) {
  const { shown } = prediction;
  return (
    <ChoiceQuestion<Times>
      prediction={prediction}
      ask="Now the gasket. When the boxes get half as wide, how many times as many does it need?"
      options={OPTIONS}
      truth="3"
      beside={
        <Picture maps={GRIDDED.gasket.maps} box={UNIT} label="A gasket with its corner at the lower left." />
      }
      after={
        shown && (
          <>
            <Counting as="counted" names={["gasket", "carpet", "line", "square"]} />
            <TooMuch />
          </>
        )
      }
      line="Three times as many, so its dimension is 1.585: 2 to the power of 1.585 is 3."
    >
      <p>
        The gasket is more than a line and less than a square, and its dimension says by how much. It follows
        from the maps alone: three of scale ½. If boxes half as wide are three times as many, then{" "}
        <Formula tex={tex`3 \cdot (\frac{1}{2})^D = 1`} />.
      </p>
      <p>
        So it goes for any shape made of smaller copies with scales <Formula tex={tex`r_1, r_2, \dots`} />{" "}
        that do not overlap: the powers with <Formula>D</Formula> sum to 1. That is Moran’s equation. Eight
        copies of a third, the carpet, give 1.893.
      </p>
    </ChoiceQuestion>
  );
}

/** The dust step by step: a bar becomes two, each as long as the scale says. */
function Bars({ r }: { r: number }) {
  const rows = useMemo(() => [0, 1, 2, 3, 4, 5].map((steps) => copies(dust(r), steps)), [r]);
  return (
    <svg
      class={css["bars"]}
      viewBox="0 0 100 23"
      role="img"
      aria-label={`A dust of two pieces of scale ${fixed(r)}, step by step.`}
    >
      {rows.map((row, i) =>
        row.map(({ map: [a, , , , e] }) => (
          <rect key={e} x={100 * e} y={4 * i} width={Math.max(0.15, 100 * a)} height={2.5} />
        )),
      )}
    </svg>
  );
}

function HalfDust() {
  const [r, setR] = useKept("x1.scale", 0.4, number(0.05, 0.5));
  const d = moran([r, r]);
  return (
    <Exercise
      number={1}
      ask="Here is a dust of two pieces on a line. Choose their scale so that its dimension is exactly ½."
      hints={[
        "Moran’s equation for two equal scales: 2 · rᴰ = 1.",
        "With D = ½ that says that the square root of r is ½.",
      ]}
      solved={Math.abs(r - 0.25) < 1e-9}
      status={`Scale ${fixed(r)}: dimension ${fixed(d, 3)}.`}
    >
      <Bars r={r} />
      <div class={layout["controls"]}>
        <SliderControl
          label="scale"
          symbol="r"
          range={[0.05, 0.5]}
          step={0.01}
          value={r}
          onChange={(next) => setR(Number(next.toFixed(2)))}
        />
      </div>
    </Exercise>
  );
}

function Roomy() {
  const [r, setR] = useKept("x2.scale", 0.4, number(0.3, 0.6));
  const maps = useMemo(() => gasket(r), [r]);
  const judged = useVerdict(maps, EXACT);
  const fresh = judged?.maps === maps ? judged.answer : null;
  const d = moran([r, r, r]);
  const overlapping = r > 0.5;
  const whole = fresh?.verdict === "connected";
  return (
    <Exercise
      number={2}
      ask="Three equal pieces in the corners of a triangle. Make a shape in one piece, of dimension above 1.5, whose pieces meet in single points at most."
      hints={[
        "It is in one piece as soon as the pieces reach each other along the sides.",
        "Along a side of length 1 lie two pieces, each as long as the scale says.",
      ]}
      solved={fresh === null ? null : whole && !overlapping && d > 1.5}
      status={
        overlapping
          ? `Moran’s equation gives ${fixed(d, 3)}; but the pieces overlap, so the dimension may be less.`
          : `Dimension ${fixed(d, 3)}.`
      }
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Panel
          caption={
            <VerdictChip epsilon={EXACT} answer={judged?.answer ?? null} stale={judged?.maps !== maps} />
          }
        >
          <Picture
            maps={maps}
            box={{ x0: 0, y0: 0, x1: 1, y1: HEIGHT }}
            label={`Three pieces of scale ${fixed(r)} in the corners of a triangle.`}
          />
        </Panel>
        <SliderControl
          label="scale"
          symbol="r"
          range={[0.3, 0.6]}
          step={0.01}
          value={r}
          onChange={(next) => setR(Number(next.toFixed(2)))}
        />
      </div>
    </Exercise>
  );
}
