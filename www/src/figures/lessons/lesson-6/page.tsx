import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import type { MapRow, Mode } from "#wasm/api";
import { Plot } from "../../kit/chart/plot";
import { QUARTERS } from "../../kit/chart/scale";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { determinant, gasket, turnedGasket } from "../../kit/maps/families";
import { boxAround, determinants, type Ends, mapsAt } from "../../kit/maps/morphs";
import { tex } from "../../kit/notation/tex";
import { Picture } from "../../kit/picture/picture";
import { Time, useTime } from "../../kit/time/time";
import { ChoiceQuestion } from "../frame/choice-question";
import { Lesson } from "../frame/lesson";
import { type Prediction, useChoice } from "../frame/prediction";
import { Halved, Stopped } from "./exercises";
import { flagPath, turned } from "./flag";
import flagCss from "./flag.module.css";
import { TEACHING } from "./teaching";

const FRAMES = 7;
const SCALE = 0.5;
const QUARTER: Ends = { from: [turned(Math.PI / 2, SCALE)], to: [turned(0, SCALE)] };
const HALF: Ends = { from: turnedGasket(), to: gasket(0.5) };
const MODES: readonly { mode: Mode; name: string }[] = [
  { mode: "linear", name: "number by number" },
  { mode: "polar", name: "by turning" },
];
type Halfway = "same" | "half" | "point" | "mirror";

/** Why polar. */
export function Page(heading: Heading) {
  const prediction = useChoice<Halfway>(OPTIONS);
  const time = useTime(0.5);
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            A map turns, stretches and moves. It is written as six numbers. To go from one map to another, one
            might blend the numbers: half-way, take the mean of each. Below, a letter is turned back by a
            quarter like that. It arrives, but it is too small on the way.
          </p>
          <p>
            The other way splits a map into a turn and a stretch, as a point on a plane may be given by an
            angle and a distance: this is its <em>polar</em> form. Blend the angle, and the stretch by itself.
            Now the letter swings round and keeps its size.
          </p>
        </>
      }
      question={<Turn prediction={prediction} time={time} />}
      exercises={
        <>
          <Halved />
          <Stopped />
        </>
      }
      teaching={TEACHING}
      parameters={[
        { name: "The map above", value: "scale ½, from a quarter turn to none" },
        { name: "The map in the question", value: "scale ½, from a half turn to none" },
        {
          name: "Half-way, a quarter turn, number by number",
          value: ["scale 0.354, which is ", tex`\tfrac12 \sqrt{\tfrac12}`],
        },
        {
          name: "Maps 2 and 3 of the shape",
          value: [
            tex`f_2(x) = \tfrac12 x + (\tfrac12, 0)`,
            tex`f_3(x) = \tfrac12 x + (\tfrac14, \tfrac{\sqrt{3}}{4})`,
          ],
        },
      ]}
      sources={
        <p>
          Ken Shoemake and Tom Duff proposed polar decomposition for animation (1992), and Burch and Hart use
          it for shapes. The half turn is that of their <a href="#figures/3">Figures 3 and 4</a>, where both
          ways are told at length.
        </p>
      }
      studio={{
        href: studioHref({
          a: { name: "Gasket, map 1 turned", maps: HALF.from },
          b: preset("gasket"),
          t: time.t,
          compare: true,
        }),
      }}
    >
      {MODES.map(({ mode, name }) => (
        <Flags key={mode} mode={mode} name={name} />
      ))}
    </Lesson>
  );
}

/** The letter at even times of a quarter turn. */
function Flags({ mode, name }: { mode: Mode; name: string }) {
  const maps = useMemo(
    () => Array.from({ length: FRAMES }, (_, i) => at(QUARTER, i / (FRAMES - 1), mode)),
    [mode],
  );
  const middle = Math.sqrt(determinant(maps[(FRAMES - 1) / 2] ?? [0, 0, 0, 0, 0, 0]));
  return (
    <div class={layout["film-row"]}>
      <h2>{name[0]?.toUpperCase() + name.slice(1)}</h2>
      <svg
        class={flagCss["flags"]}
        viewBox={`0 0 ${70 * FRAMES} 70`}
        role="img"
        aria-label={`A letter F turned back by a quarter in ${FRAMES} frames, ${name}: its scale is 0.5 at both ends and ${fixed(middle, 3)} half-way.`}
      >
        {maps.map((map, i) => (
          <g key={`${i + 1}`} transform={`translate(${70 * i + 35} 35)`}>
            <circle r={33} class={flagCss["flag-ring"]} />
            <path class={flagCss["flag"]} d={flagPath(map, 52)} />
          </g>
        ))}
      </svg>
    </div>
  );
}

function at(ends: Ends, t: number, mode: Mode): MapRow {
  return mapsAt(ends, [t, t], mode)[0] ?? [0, 0, 0, 0, 0, 0];
}

interface TurnProps {
  prediction: Prediction<Halfway>;
  time: ReturnType<typeof useTime>;
}

const OPTIONS = [
  {
    value: "same",
    label: "The letter on its side, as large as before",
    wrong:
      "So it would be by turning. But the means of the numbers know nothing of an angle: compare both rows above.",
  },
  {
    value: "half",
    label: "The letter on its side, half as large",
    wrong: "Smaller, yes, as in the upper row above, but a half turn takes off more than a quarter turn did.",
  },
  { value: "point", label: "A single point" },
  {
    value: "mirror",
    label: "The letter in the mirror",
    wrong: "A mirror changes the sign of one direction and leaves the other. A half turn changes both alike.",
  },
] as const;

function Turn({ prediction, time }: TurnProps) {
  const { shown } = prediction;
  return (
    <ChoiceQuestion<Halfway>
      prediction={prediction}
      ask="Now the letter is upside down and is turned back by a half turn, number by number. What is it half-way?"
      options={OPTIONS}
      truth="point"
      beside={<Ask shown={shown} />}
      after={<Shapes time={time} />}
      line="Half-way it is a single point: every number of the map is 0."
    >
      <p>
        A half turn changes the sign of every number: ½ becomes −½. Their mean is 0, so the map sends
        everything to one place, and the piece vanishes. How much of an area a map leaves is told by its{" "}
        <em>determinant</em>: it falls to 0 in the middle, while by turning it never changes.
      </p>
    </ChoiceQuestion>
  );
}

/** Both ends, and between them what is asked for. */
function Ask({ shown }: { shown: boolean }) {
  const half = { from: [turned(Math.PI, SCALE)], to: [turned(0, SCALE)] };
  return (
    <svg
      class={flagCss["flags"]}
      viewBox="0 0 230 80"
      role="img"
      aria-label={
        shown
          ? "The letter upside down, then a single point, then the letter upright."
          : "The letter upside down, a question mark, and the letter upright."
      }
    >
      {[0, 0.5, 1].map((t, i) => (
        <g key={t} transform={`translate(${75 * i + 40} 40)`}>
          <circle r={33} class={flagCss["flag-ring"]} />
          {t !== 0.5 && <path class={flagCss["flag"]} d={flagPath(at(half, t, "linear"), 52)} />}
          {t === 0.5 && shown && <circle class={flagCss["flag"]} r={2} />}
          {t === 0.5 && !shown && (
            <text class={flagCss["flag-ask"]} dy="0.35em" text-anchor="middle">
              ?
            </text>
          )}
        </g>
      ))}
    </svg>
  );
}

/** The half turn in a shape, both ways, with the determinant of the map that turns. */
function Shapes({ time }: { time: ReturnType<typeof useTime> }) {
  const { t } = time;
  const all = useMemo(() => MODES.map(({ mode }) => mapsAt(HALF, [t, t], mode)), [t]);
  const box = useMemo(() => boxAround([HALF.from, HALF.to]), []);
  const curves = useMemo(() => MODES.map(({ mode }) => determinants(HALF, mode)), []);
  return (
    <>
      <p>The same in a shape: its lower left piece (1) is turned by a half turn.</p>
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        {MODES.map(({ mode, name }, i) => (
          <Panel key={mode} caption={name}>
            <Picture
              maps={all[i] ?? []}
              box={box}
              label={`The shape at t = ${fixed(t)}, ${name}: map 1 has determinant ${fixed(determinant(all[i]?.[0] ?? [0, 0, 0, 0, 0, 0]), 3)}.`}
            />
          </Panel>
        ))}
      </div>
      <Time time={time} words={`determinant ${fixed((t - 0.5) ** 2, 3)} against 0.25`} />
      <Plot
        label="The determinant of map 1: number by number it falls from 0.25 to 0 at t = 0.5 and rises again, by turning it stays at 0.25."
        x={{ name: "t", ...QUARTERS }}
        y={{ name: "determinant of map 1", min: 0, max: 0.3, ticks: [0, 0.1, 0.2, 0.3] }}
        now={t}
        series={[
          { name: "by turning", points: curves[1] ?? [], colour: 1, nameAt: 20 },
          {
            name: "number by number",
            points: curves[0] ?? [],
            colour: 5,
            dashed: true,
            nameAt: 20,
            raise: 12,
          },
        ]}
      />
    </>
  );
}
