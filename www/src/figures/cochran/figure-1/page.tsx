import { useMemo } from "preact/hooks";
import { fixed, formatNumber } from "#format/numbers";
import { NumberField } from "#ui/controls/NumberField";
import { Switch } from "#ui/controls/Switch";
import { loadCurves, rough } from "#wasm/curve";
import { QUARTERS } from "../../kit/chart/scale";
import { SliderControl } from "../../kit/frame/control";
import { Formula } from "../../kit/frame/formula";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { fitHref } from "../../kit/frame/studio-link";
import { tex } from "../../kit/notation/tex";
import { flag, list, number, only, point } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { byPiece, rangeOf } from "../graphs/graphs";
import { Profile } from "../graphs/profile";
import { Grip } from "./grip";
import { FIGURE_1, interpolated, type Points } from "./interpolation";
import css from "./page.module.css";

/** The rougher the higher; at 1 there is no end to it. */
const MOST_C = 0.95;
const LOW = -1;
const HIGH = 2;
const LEAST_GAP = 0.02;
const T = { ...QUARTERS, name: "t" };
/** What of the points has a field: the first and the last keep their t. */
const FIELDS = [
  { label: "First point", symbol: "x₀", of: [0, "x"] },
  { label: "Middle, across", symbol: "t₁", of: [1, "t"] },
  { label: "Middle, up", symbol: "x₁", of: [1, "x"] },
  { label: "Last point", symbol: "x₂", of: [2, "x"] },
] as const;
const POINT_NAMES = ["First point", "Middle point", "Last point"];

/** Where points may be: the first and the last at the ends of the interval, the middle one well between. */
const isPlace = (index: number, t: number) =>
  index === 1 ? t >= LEAST_GAP && t <= 1 - LEAST_GAP : t === index / 2;

/** What stands in its address. */
export const STATE = {
  points: kept<Points>(
    FIGURE_1.points,
    // In order, with their ends where the interval has its own, and as high as they can be dragged.
    only(list(point(LOW, HIGH), 3, 3, ";"), (points) =>
      points.every(([t, x], i) => isPlace(i, t) && x <= HIGH),
    ),
  ),
  c: kept(FIGURE_1.c, list(number(-MOST_C, MOST_C, 3), 2, 2)),
  backwards: kept<readonly boolean[]>([false, false], list(flag, 2, 2)),
};

/** What must be there before it is shown. */
export const needs = [loadCurves];

/** A fractal interpolation function, to be taken hold of. */
export function Page(heading: Heading) {
  const [points, setPoints] = useKept("points", ...STATE.points);
  const [c, setC] = useKept("c", ...STATE.c);
  const [reflected, setReflected] = useKept("backwards", ...STATE.backwards);
  const graph = useMemo(() => interpolated(points, c, reflected), [points, c, reflected]);
  const facts = useMemo(() => rough.graphFacts(graph), [graph]);
  const samples = useMemo(() => rough.sampleGraph(graph, { tolerance: 0.004, most: 20_000 }), [graph]);
  const y = rangeOf([samples], { min: -0.25, max: 1.75 });
  const move = (index: number, t: number, x: number) =>
    setPoints(points.map((point, i) => (i === index ? [within(index, t, points), clamp(x)] : point)));
  const setFactor = (index: number, value: number) =>
    setC(c.map((old, i) => (i === index ? Math.min(MOST_C, Math.max(-MOST_C, value)) : old)));
  return (
    <Frame
      {...heading}
      lead={
        <p>
          Three points, and a curve through them that is not smooth anywhere: its left half is the whole
          curve, squeezed and sheared, and so is its right half. How much of the whole’s height a half keeps
          is its roughness, <Formula>c</Formula>. Take hold of the points, and turn the roughness down to 0:
          what is left is the straight lines. Below 0 the copies hang upside down.
        </p>
      }
      found={
        <p>
          Counted in boxes, this graph has the dimension{" "}
          {facts.dimension === null ? "–" : fixed(facts.dimension, 3)}: 1 is a line, 2 would fill the plane.
          It rises above 1 as soon as the two roughnesses, signs aside, add up to more than 1. The area under
          it is {facts.integral === null ? "–" : fixed(facts.integral, 4)}, exactly, although nobody could
          draw all of it: the integral obeys the same rule of copies.
        </p>
      }
      parameters={[
        ...points.map(([t, x], i) => ({
          name: POINT_NAMES[i] ?? "",
          symbol: tex`(t_${i}, x_${i})`,
          value: [tex`(${formatNumber(t)}, ${formatNumber(x)})`],
        })),
        ...c.map((value, i) => ({
          name: i === 0 ? "Roughness, left" : "Roughness, right",
          symbol: tex`c_${i + 1}`,
          value: formatNumber(value),
        })),
        ...graph.pieces.map(({ map: [a, b, factor, d, e] }, i) => ({
          name: `Map ${i + 1}`,
          symbol: tex`f_${i + 1}`,
          value: [
            tex`t \mapsto ${formatNumber(a)}\, t + ${formatNumber(d)}`,
            tex`x \mapsto ${formatNumber(b)}\, t + ${formatNumber(factor)}\, x + ${formatNumber(e)}`,
          ],
        })),
        { name: "Contractivity in the metric of eq 2", symbol: "s", value: fixed(facts.contractivity, 3) },
      ]}
      captions={[
        "Figure 1: Graph of a fractal interpolation function of the points (0, 0), (0.5, 1), (1, 0) using c1 = 0.6 and c2 = 0.4",
      ]}
      reconstructed={null}
      differs="On the left of eq 1 the paper prints x and y; it is the point (t, x) that is mapped. Reflected copies are in its section 2.1, but not in its figure."
      studio={{ href: fitHref({ mode: "graph", graph }), label: "Open in the Fit tool" }}
    >
      <Profile
        label={`The curve through ${points.map(([t, x]) => `(${formatNumber(t)}, ${formatNumber(x)})`).join(", ")} with roughness ${c.map((value) => formatNumber(value)).join(" and ")}`}
        x={T}
        y={{ ...y, name: "x" }}
        height={340}
        lines={[
          { points: points.flat(), colour: "quiet", width: 1, dashed: true },
          ...byPiece(graph, samples).map((piece, i) => ({ points: piece, colour: i })),
        ]}
      >
        {(place, size) =>
          points.map(([t, x], i) => (
            <Grip
              key={POINT_NAMES[i]}
              name={POINT_NAMES[i] ?? ""}
              t={t}
              x={x}
              place={place}
              size={size}
              valueAt={(left, top) => [left / size.width, y.max - (top / size.height) * (y.max - y.min)]}
              onMove={(nextT, nextX) => move(i, nextT, nextX)}
            />
          ))
        }
      </Profile>
      <div class={layout["controls"]}>
        {c.map((value, i) => (
          <SliderControl
            key={POINT_NAMES[i]}
            label={i === 0 ? "roughness, left" : "roughness, right"}
            name={i === 0 ? "Roughness of the left piece" : "Roughness of the right piece"}
            symbol={tex`c_${i + 1}`}
            range={[-MOST_C, MOST_C]}
            value={value}
            valueText={`c = ${fixed(value)}`}
            onChange={(next) => setFactor(i, next)}
            below={
              <Switch
                checked={reflected[i] ?? false}
                onChange={(next) => setReflected(reflected.map((old, k) => (k === i ? next : old)))}
              >
                {i === 0 ? "Left copy runs backwards" : "Right copy runs backwards"}
              </Switch>
            }
          />
        ))}
      </div>
      <div class={css["point-fields"]}>
        {FIELDS.map(({ label, symbol, of: [index, axis] }) => {
          const [t = 0, x = 0] = points[index] ?? [];
          return (
            <NumberField
              key={symbol}
              label={label}
              symbol={symbol}
              value={axis === "t" ? t : x}
              min={axis === "t" ? LEAST_GAP : LOW}
              max={axis === "t" ? 1 - LEAST_GAP : HIGH}
              onChange={(value) => (axis === "t" ? move(index, value, x) : move(index, t, value))}
            />
          );
        })}
      </div>
    </Frame>
  );
}

function clamp(x: number): number {
  return Math.round(Math.min(HIGH, Math.max(LOW, x)) * 1000) / 1000;
}

/** Where a point may be on the t axis: the first and the last stay, the others keep their order. */
function within(index: number, t: number, points: Points): number {
  if (index === 0) return 0;
  if (index === points.length - 1) return 1;
  const before = (points[index - 1]?.[0] ?? 0) + LEAST_GAP;
  const behind = (points[index + 1]?.[0] ?? 1) - LEAST_GAP;
  return Math.round(Math.min(behind, Math.max(before, t)) * 1000) / 1000;
}
