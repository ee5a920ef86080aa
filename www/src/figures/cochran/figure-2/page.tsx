import { useMemo } from "preact/hooks";
import { fixed, formatNumber } from "#format/numbers";
import { TABLE_1 as TABLE_1_GRAPH } from "#tools/fit/graph/printed";
import { loadCurves, rough } from "#wasm/curve";
import { Choice, SliderControl } from "../../kit/frame/control";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { fitHref } from "../../kit/frame/studio-link";
import { tex } from "../../kit/notation/tex";
import { number, oneOf, whole } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { byPiece, fixedPointImages, rangeOf } from "../graphs/graphs";
import { MapTable } from "../graphs/map-table";
import { applied, TABLE_1 } from "../graphs/printed-tables";
import { type Line, Profile } from "../graphs/profile";

const T = { min: -1, max: 1, ticks: [-1, -0.5, 0, 0.5, 1], name: "t" };
const MOST_LEVEL = 7;
/** Powers of ten by which the place where the pieces meet is magnified. */
const CLOSEST = 4;

/** Both sides of the place where the two pieces should meet. */
function misfit(): { left: number; right: number } {
  const [one, two] = TABLE_1 as [(typeof TABLE_1)[number], (typeof TABLE_1)[number]];
  const fixedPoint = ([a, b, c, d, e]: (typeof one)["map"]): [number, number] => {
    const t = d / (1 - a);
    return [t, (b * t + e) / (1 - c)];
  };
  return {
    left: applied(one.map, fixedPoint(two.map))[1],
    right: applied(two.map, fixedPoint(one.map))[1],
  };
}

/** What stands in its address. */
export const STATE = {
  features: kept(6, whole(0, MOST_LEVEL)),
  show: kept<"whole" | "copies">("whole", oneOf(["whole", "copies"])),
  closer: kept(0, number(0, CLOSEST, 1)),
};

/** What must be there before it is shown. */
export const needs = [loadCurves];

/** The function of Table 1, and where its maps meet. */
export function Page(heading: Heading) {
  const [level, setLevel] = useKept("features", ...STATE.features);
  const [shown, setShown] = useKept("show", ...STATE.show);
  const [closer, setCloser] = useKept("closer", ...STATE.closer);
  const samples = useMemo(() => rough.sampleGraph(TABLE_1_GRAPH, { tolerance: 0.003, most: 20_000 }), []);
  const facts = useMemo(() => rough.graphFacts(TABLE_1_GRAPH), []);
  const features = useMemo(() => fixedPointImages(TABLE_1, level), [level]);
  const y = { ...rangeOf([samples], { min: -1, max: 1.25 }), name: "x" };
  const copies = byPiece(TABLE_1_GRAPH, samples);
  const lines: Line[] =
    shown === "copies"
      ? copies.map((points, i) => ({ points, colour: i }))
      : [{ points: samples, colour: "ink", width: 1.25 }];
  return (
    <Frame
      {...heading}
      lead={
        <p>
          Two maps, ten numbers, and this mountain range is all there is to them: the left half is the whole
          pressed into half the width, the right half is the whole upside down. The numbers stand in the table
          below. In Table 2 they are forgotten and found again, from nothing but the points that you can show
          here.
        </p>
      }
      found={
        <p>
          The table is rounded to three digits, so the two pieces do not quite meet: coming from the left the
          graph ends at {fixed(misfit().left, 6)}, on the right it begins at {fixed(misfit().right, 6)}. The
          step of {fixed(misfit().left - misfit().right, 6)} is too small for any figure on paper. Magnify the
          middle and it is there, and since all is copied, it is there again in every part of every part. The
          box dimension is {facts.dimension === null ? "–" : fixed(facts.dimension, 3)}.
        </p>
      }
      parameters={[
        { name: "Interval", value: "[−1, 1]" },
        { name: "Height at the ends", symbol: tex`F(\pm 1)`, value: "−1 and −0.00625" },
        { name: "Feature points shown", symbol: tex`2^k + 1`, value: String(features.length) },
        { name: "Step at the middle", value: fixed(facts.widestGap, 6) },
        { name: "Contractivity in the metric of eq 2", symbol: "s", value: fixed(facts.contractivity, 3) },
      ]}
      captions={["Figure 2: Fractal function with two maps.", "Table 1: FIF Parameters for Figure 2."]}
      reconstructed={null}
      differs="The paper speaks of the interval from 0 to 1; the table’s numbers live on [−1, 1]. That its pieces do not meet exactly is not said there."
      studio={{ href: fitHref({ mode: "graph", graph: TABLE_1_GRAPH }), label: "Open in the Fit tool" }}
    >
      <div class={layout["controls"]}>
        <Choice
          label="Show"
          name="What is shown"
          options={[
            { value: "whole", label: "The graph" },
            { value: "copies", label: "Its two copies" },
          ]}
          value={shown}
          onChange={setShown}
        />
        <SliderControl
          label="feature points"
          symbol={tex`2^k + 1`}
          range={[0, MOST_LEVEL]}
          whole
          value={level}
          text={String(features.length)}
          valueText={`${features.length} points`}
          onChange={setLevel}
        />
      </div>
      <Profile
        label={`The function of Table 1 over −1 to 1 with ${features.length} feature points`}
        x={T}
        y={y}
        height={340}
        lines={lines}
        dots={[{ points: features.flat(), colour: 5, size: level > 6 ? 3 : 4.5 }]}
      />
      <div class={layout["fit-columns"]}>
        <Panel
          caption={
            <SliderControl
              label="the middle, magnified"
              range={[0, CLOSEST]}
              step={0.1}
              value={closer}
              text={`${formatNumber(10 ** closer, 0)} times`}
              onChange={setCloser}
            />
          }
        >
          <Closer closer={closer} />
        </Panel>
        <MapTable
          caption="Table 1: the two maps"
          rows={TABLE_1.map(({ map }, i) => ({ name: `T${String.fromCharCode(0x2081 + i)}`, map }))}
        />
      </div>
    </Frame>
  );
}

/** What lies around the place where the pieces meet. */
function Closer({ closer }: { closer: number }) {
  const reach = 10 ** -closer;
  const { left, right } = misfit();
  const lines = useMemo(() => {
    const part = (from: number, to: number) =>
      rough.sampleGraph(TABLE_1_GRAPH, { tolerance: 0.002 * reach, window: [from, to], most: 20_000 });
    const within = (points: Float64Array, from: number, to: number) => {
      const kept: number[] = [];
      for (let i = 0; i + 1 < points.length; i += 2) {
        const t = points[i] ?? 0;
        if (t >= from && t <= to) kept.push(t, points[i + 1] ?? 0);
      }
      return kept;
    };
    const tiny = 1e-9;
    return [
      [...within(part(-reach, 0), -1, -tiny), 0, left],
      [0, right, ...within(part(0, reach), tiny, 1)],
    ];
  }, [reach, left, right]);
  const middle = (left + right) / 2;
  // Heights shrink more slowly than widths: half the width leaves six tenths of the height.
  const tall = 2.2 * reach ** (Math.log(0.55) / Math.log(0.5));
  return (
    <Profile
      label={`The middle magnified ${formatNumber(10 ** closer, 0)} times: the left piece ends at ${fixed(left, 6)}, the right one begins at ${fixed(right, 6)}`}
      x={{ min: -reach, max: reach, ticks: [-reach, 0, reach], format: (t) => formatNumber(t, 4) }}
      y={{
        min: middle - tall,
        max: middle + tall,
        ticks: [middle - tall / 2, middle, middle + tall / 2],
        format: (x) => fixed(x, tall > 0.5 ? 1 : 4),
      }}
      height={240}
      lines={lines.map((points, i) => ({ points, colour: i }))}
      dots={[
        { points: [0, left], colour: 0, size: 8 },
        { points: [0, right], colour: 1, size: 8, hollow: true },
      ]}
    />
  );
}
