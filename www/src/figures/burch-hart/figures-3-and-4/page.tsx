import { useMemo } from "preact/hooks";
import type { Box } from "#document/framing";
import { fixed } from "#format/numbers";
import { verdictPhrase } from "#format/verdict";
import type { MapRow, Mode } from "#wasm/api";
import { loadProof, prover } from "#wasm/proof";
import { Plot } from "../../kit/chart/plot";
import { QUARTERS } from "../../kit/chart/scale";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { VerdictChip } from "../../kit/frame/verdict";
import { type Breakage, breakage, shareWords, stretchWords } from "../../kit/maps/breakage";
import { determinant, gasket, HEIGHT, turnedGasket } from "../../kit/maps/families";
import { boxAround, determinants, type Ends, framesAlong, mapsAt, STRAIGHT } from "../../kit/maps/morphs";
import { tex } from "../../kit/notation/tex";
import { Picture } from "../../kit/picture/picture";
import { Strip, type StripFrame } from "../../kit/picture/stills";
import { Time, useTime } from "../../kit/time/time";
import { SAMPLES, useStates, useVerdict } from "../../kit/workers";

const FRAMES = 9;
/** Bounds that take some milliseconds. */
const NEAR = { tolerance: 1e-3, budget: 100_000 };
const ENDS: Ends = { from: turnedGasket(), to: gasket(0.5) };
const MODES: readonly { mode: Mode; number: string; caption: string; short: string }[] = [
  {
    mode: "linear",
    number: "Figure 3",
    short: "number by number",
    caption: "Figure 3: Linear interpolation of IFS transformation matrix elements.",
  },
  {
    mode: "polar",
    number: "Figure 4",
    short: "by turning",
    caption: "Figure 4: Polar interpolation of IFS transformation matrices.",
  },
];

/** The same with map 1 turned about the middle of its piece, and with the corners of a right-angled triangle. */
const TURNED_ABOUT_ITS_MIDDLE: Ends = { from: turnedAt(gasket(0.5), [0.5, HEIGHT / 2]), to: gasket(0.5) };
const RIGHT: MapRow[] = [
  [0.5, 0, 0, 0.5, 0, 0],
  [0.5, 0, 0, 0.5, 0.5, 0],
  [0.5, 0, 0, 0.5, 0, 0.5],
];
const RIGHT_ANGLED: Ends = { from: turnedAt(RIGHT, [0, 0]), to: RIGHT };

/** Map 1 turned by half a turn, and moved by so much. */
function turnedAt([, ...others]: MapRow[], [e, f]: [number, number]): MapRow[] {
  return [[-0.5, 0, 0, -0.5, e, f], ...others];
}

/** What the page needs before it is drawn. */
export const needs = [loadProof];

/** Linear beside polar interpolation. */
export function Page(heading: Heading) {
  const time = useTime(0.35);
  const films = useMemo(() => MODES.map(({ mode }) => framesAlong(ENDS, STRAIGHT, FRAMES, mode)), []);
  const box = useMemo(() => boxAround(films.flat().map((frame) => frame.maps)), [films]);
  const linear = useBreakage(ENDS, "linear");
  const polar = useBreakage(ENDS, "polar");
  const middle = useBreakage(TURNED_ABOUT_ITS_MIDDLE, "polar");
  const right = useBreakage(RIGHT_ANGLED, "polar");
  return (
    <Frame
      {...heading}
      lead={
        <p>
          The two ends differ in one map only: the lower left one (1) is turned by half a turn. Blend its
          numbers one by one and it shrinks to a point half-way, where its determinant is 0. Split it into a
          turn and a stretch, blend these, and it swings round at its full size. By Theorem 1 (Barnsley 1988)
          neither jumps: where the maps change continuously with a bounded parameter, and shrink all the
          while, so does the shape: its Hausdorff distance from the first frame changes without a jump. That
          it stays in one piece is not said by it.
        </p>
      }
      found={<Found linear={linear} polar={polar} others={[middle, right]} />}
      parameters={[
        { name: "First shape, map 1", value: [tex`f_1(x) = -\tfrac12 x`, ", turned by 180°"] },
        { name: "Last shape, map 1", value: [tex`f_1(x) = \tfrac12 x`] },
        {
          name: "Maps 2 and 3 of both",
          value: [
            tex`f_2(x) = \tfrac12 x + (\tfrac12, 0)`,
            tex`f_3(x) = \tfrac12 x + (\tfrac14, \tfrac{\sqrt{3}}{4})`,
          ],
        },
        { name: "Path", value: "u = v = t, straight" },
        { name: "Frames in a strip", value: String(FRAMES) },
        { name: "Resolution of the verdicts", symbol: "ε", value: "1/600 of the shape" },
      ]}
      captions={MODES.map(({ caption }) => caption)}
      reconstructed="The paper says that both shapes have three maps and that the lower left one is rotated by 180°, and prints no numbers. Taken at its word, the gasket’s map ½ x becomes −½ x with its translation as it is."
      studio={{ href: href(time.t) }}
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        {MODES.map(({ mode, number, short }) => (
          <Side key={mode} mode={mode} number={number} short={short} t={time.t} box={box} />
        ))}
      </div>
      <Time time={time} words={`determinant ${fixed((time.t - 0.5) ** 2, 3)} against 0.25`} />
      <Determinants t={time.t} />
      {MODES.map(({ mode, number, short }, i) => (
        <div key={mode} class={layout["film-row"]}>
          <h2>
            {number}, {short}
          </h2>
          <Strip
            label={`${number}: frames`}
            frames={films[i] as StripFrame[]}
            box={box}
            t={time.t}
            onPick={time.go}
          />
        </div>
      ))}
    </Frame>
  );
}

interface SideProps {
  mode: Mode;
  number: string;
  short: string;
  t: number;
  box: Box;
}

function Side({ mode, number, short, t, box }: SideProps) {
  const maps = useMemo(() => mapsAt(ENDS, [t, t], mode), [mode, t]);
  const judged = useVerdict(maps);
  const det = maps[0] ? determinant(maps[0]) : 0;
  const moved = useMemo(() => prover().hausdorffDistance({ maps: ENDS.from }, { maps }, NEAR), [maps]);
  return (
    <Panel
      name={number}
      words={short}
      caption={
        <>
          <VerdictChip answer={judged?.answer ?? null} stale={judged?.maps !== maps} />
          <span class="number">
            determinant of map 1: <strong>{fixed(det, 3)}</strong>
          </span>
          <span class="number">
            Hausdorff distance from t = 0:{" "}
            <strong>
              {fixed(moved.lower, 3)} to {fixed(moved.upper, 3)}
            </strong>
          </span>
        </>
      }
    >
      <Picture
        maps={maps}
        box={box}
        label={`${number} at t = ${fixed(t)}: ${verdictPhrase(judged?.answer ?? null)}`}
      />
    </Panel>
  );
}

function Determinants({ t }: { t: number }) {
  const curves = useMemo(() => MODES.map(({ mode }) => determinants(ENDS, mode)), []);
  return (
    <Plot
      label="The determinant of map 1 over the morph: in Figure 3 it falls from 0.25 to 0 at t = 0.5 and rises again, in Figure 4 it stays at 0.25."
      x={{ name: "t", ...QUARTERS }}
      y={{ name: "determinant of map 1", min: 0, max: 0.3, ticks: [0, 0.1, 0.2, 0.3] }}
      now={t}
      series={[
        { name: "Figure 4", points: curves[1] ?? [], colour: 1, nameAt: 20 },
        { name: "Figure 3", points: curves[0] ?? [], colour: 5, dashed: true, nameAt: 12, raise: -18 },
      ]}
    />
  );
}

function useBreakage(ends: Ends, mode: Mode): Breakage | null {
  const way = useMemo(() => ({ ...ends, options: { mode }, points: STRAIGHT }), [ends, mode]);
  const states = useStates(way);
  return useMemo(() => (states ? breakage(states) : null), [states]);
}

interface FoundProps {
  linear: Breakage | null;
  polar: Breakage | null;
  /** Figure 4 as the paper may be read otherwise. */
  others: readonly (Breakage | null)[];
}

function Found({ linear, polar, others: [middle, right] }: FoundProps) {
  if (!linear || !polar || !middle || !right) return <p>Looking at {SAMPLES} moments of each morph …</p>;
  const whole = polar.stretches
    .slice(1)
    .map((next, i) => ({ t0: polar.stretches[i]?.t1 ?? 0, t1: next.t0 }))
    .filter(({ t0, t1 }) => t1 - t0 > 0.004);
  return (
    <p>
      The paper says of both figures that “all of the intermediate attractors are disconnected”. Of {SAMPLES}{" "}
      moments judged here, {mostWords(linear)} are in pieces in Figure 3 and {shareWords(polar.share)} in
      Figure 4, where the swinging piece lies across both others for a while ({stretchWords(whole)}). A strip
      of five frames happens to miss that; this one of {FRAMES} does not. No reading of the paper that was
      tried here gave all: with map 1 turned about the middle of its piece it is {shareWords(middle.share)},
      with a right-angled triangle {shareWords(right.share)}, and turning the other way round, or from the
      gasket to the turned one, gave no more than 84% either.
    </p>
  );
}

/** The moments next to the ends are as good as whole: no resolution tells them apart. */
function mostWords({ share, stretches: [first, ...more] }: Breakage): string {
  const nearly = more.length === 0 && first !== undefined && first.t0 < 0.01 && first.t1 > 0.99;
  return nearly ? "all but those next to the ends" : shareWords(share);
}

function href(t: number): string {
  return studioHref({
    a: { name: "Gasket, map 1 turned", maps: ENDS.from },
    b: preset("gasket"),
    t,
    // As here: number by number on the left.
    mode: "linear",
    compare: true,
  });
}
