import { useMemo, useRef } from "preact/hooks";
import { fixed } from "#format/numbers";
import { Switch } from "#ui/controls/Switch";
import { Problem } from "#ui/panel/Problem";
import type { PlaneGraph } from "#wasm/api";
import { loadCurves } from "#wasm/curve";
import { Choice, SliderControl } from "../../kit/frame/control";
import { Formula } from "../../kit/frame/formula";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { fitHref } from "../../kit/frame/studio-link";
import { tex } from "../../kit/notation/tex";
import { flag, list, number, oneOf, point } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { Grip } from "../figure-1/grip";
import { rangeOf } from "../graphs/graphs";
import { PlaneMapTable } from "../graphs/plane-map-table";
import { Profile } from "../graphs/profile";
import { apart, curveThrough, drawn, FACTORS, type Factor, PLACES, type Place, wordOf } from "./plane-curve";

const [LOW, HIGH] = [-1, 2];
/** What a factor may say; whether it shrinks hangs on all four. */
const MOST = 0.95;
const KINDS = [
  { value: "apart", label: "x and y apart (eq 8)" },
  { value: "together", label: "together (eq 9)" },
] as const;
type Kind = (typeof KINDS)[number]["value"];
const POINT_NAMES = ["First point", "Middle point", "Last point"];
const ENTRIES = [
  { k: 0, name: "x from x", symbol: tex`c_x`, both: true },
  { k: 1, name: "x from y", symbol: tex`c_{xy}`, both: false },
  { k: 2, name: "y from x", symbol: tex`c_{yx}`, both: false },
  { k: 3, name: "y from y", symbol: tex`c_y`, both: true },
] as const;

const FACTOR = list(number(-MOST, MOST, 3), 4, 4);

/** What stands in its address. */
export const STATE = {
  kind: kept<Kind>("together", oneOf(KINDS.map(({ value }) => value))),
  places: kept<readonly Place[]>(PLACES, list(point(LOW, HIGH, 3), 3, 3, ";")),
  factors: kept<readonly (readonly number[])[]>(FACTORS, list(FACTOR, 2, 2, ";")),
  backwards: kept<readonly boolean[]>([false, false], list(flag, 2, 2)),
};

/** What must be there before it is shown. */
export const needs = [loadCurves];

/** Fractal curves of the plane, separable and not. */
export function Page(heading: Heading) {
  const [kind, setKind] = useKept("kind", ...STATE.kind);
  const [places, setPlaces] = useKept("places", ...STATE.places);
  const [factors, setFactors] = useKept("factors", ...STATE.factors);
  const [backwards, setBackwards] = useKept("backwards", ...STATE.backwards);
  const used = useMemo(
    () => (factors as readonly Factor[]).map((factor) => (kind === "apart" ? apart(factor) : factor)),
    [kind, factors],
  );
  const made = useMemo(() => curveThrough(places, used, backwards), [places, used, backwards]);
  // What shrinks no more is refused, and the last curve that did is kept in sight.
  const last = useRef<PlaneGraph | null>(null);
  if (typeof made !== "string") last.current = made;
  const curve = last.current;
  const lines = useMemo(() => (curve ? drawn(curve) : null), [curve]);
  const x = lines ? rangeOf([lines.x, swapped(places.flat())], { min: -0.2, max: 1.2 }) : UNIT;
  const y = lines ? rangeOf([lines.y, places.flat()], { min: -0.2, max: 0.8 }) : UNIT;
  const move = (index: number, to: Place) =>
    setPlaces(places.map((place, i) => (i === index ? [clamp(to[0]), clamp(to[1])] : place)));
  const setEntry = (piece: number, k: number, value: number) =>
    setFactors(factors.map((row, i) => (i === piece ? row.map((old, j) => (j === k ? value : old)) : row)));
  return (
    <Frame
      {...heading}
      lead={
        <p>
          A curve of the plane is two functions of one <Formula>t</Formula>, and each half of it is the whole,
          mapped. Where x only answers to x and y only to y, the two know nothing of each other. Let them
          answer to each other, and a copy can turn and lean: the curve is richer, and x alone is no function
          made of copies of itself any more. Drag the points.
        </p>
      }
      found={
        <p>
          There is one curve wherever each 2 × 2 factor shortens every direction of the plane. That is more
          than that its four numbers are below 1: four times 0.7 makes one direction longer by 1.4. Where a
          factor does not shrink, Frond says so and keeps the last curve. With factors of 0 what is left is
          the straight lines.
        </p>
      }
      parameters={[
        {
          name: "Points",
          symbol: tex`(t, x, y)`,
          value: places.map(([px, py], i) => `(${fixed(i / 2, 1)}, ${fixed(px)}, ${fixed(py)})`).join(" "),
        },
        { name: "Numbers of a map", value: kind === "apart" ? "8, and two zeros" : "10" },
        {
          name: "Contractivity in the metric of eq 2",
          symbol: "s",
          value: curve?.contractivity === undefined ? "–" : fixed(curve.contractivity, 3),
        },
      ]}
      captions={["2.4 Fractal Interpolation Curves"]}
      {...(typeof made === "string"
        ? {}
        : {
            studio: {
              href: fitHref({ mode: "plane", plane: wordOf(places, used, backwards) }),
              label: "Open in the Fit tool",
            },
          })}
      own
      reconstructed="The section has no figure: this one is made here. The points and the factors it begins with are Frond’s own."
      differs="The paper’s conditions for X print both cases as one, and its text says that a and e are shared; it is a and d."
    >
      <div class={layout["controls"]}>
        <Choice label="A map takes" name="What a map takes" value={kind} options={KINDS} onChange={setKind} />
      </div>
      <Problem words={typeof made === "string" ? `${made} The last curve that shrinks is shown.` : null} />
      <Profile
        label={`The curve through ${places.map(([px, py]) => `(${fixed(px)}, ${fixed(py)})`).join(", ")}, in two pieces`}
        x={{ ...x, name: "x" }}
        y={{ ...y, name: "y" }}
        height={340}
        lines={[
          { points: places.flat(), colour: "quiet", width: 1, dashed: true },
          ...(lines?.pieces ?? []).map((points, i) => ({ points, colour: i })),
        ]}
      >
        {(place, size) =>
          places.map(([px, py], i) => (
            <Grip
              key={POINT_NAMES[i]}
              name={POINT_NAMES[i] ?? ""}
              axes={["x", "y"]}
              t={px}
              x={py}
              place={place}
              size={size}
              valueAt={(left, top) => [
                x.min + (left / size.width) * (x.max - x.min),
                y.max - (top / size.height) * (y.max - y.min),
              ]}
              onMove={(nextX, nextY) => move(i, [nextX, nextY])}
            />
          ))
        }
      </Profile>
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        {factors.map((row, piece) => (
          <fieldset key={POINT_NAMES[piece]} class={layout["controls"]}>
            <legend class={layout["side-name"]}>{piece === 0 ? "First piece" : "Second piece"}</legend>
            {ENTRIES.filter(({ both }) => both || kind === "together").map(({ k, name, symbol }) => (
              <SliderControl
                key={k}
                label={name}
                name={`${name}, ${piece === 0 ? "first" : "second"} piece`}
                symbol={symbol}
                range={[-MOST, MOST]}
                value={row[k] ?? 0}
                onChange={(value) => setEntry(piece, k, Math.round(1000 * value) / 1000)}
              />
            ))}
            <Switch
              checked={backwards[piece] ?? false}
              onChange={(next) => setBackwards(backwards.map((old, i) => (i === piece ? next : old)))}
            >
              {piece === 0 ? "First copy runs backwards" : "Second copy runs backwards"}
            </Switch>
          </fieldset>
        ))}
      </div>
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        {lines &&
          (
            [
              ["x", lines.x, x],
              ["y", lines.y, y],
            ] as const
          ).map(([name, points, scale]) => (
            <Panel
              key={name}
              name={`${name} over t`}
              words={kind === "apart" ? "a function of its own" : "with a hidden variable"}
            >
              <Profile
                label={`${name} as a function of t`}
                x={{ min: 0, max: 1, ticks: [0, 0.5, 1], name: "t" }}
                y={{ ...scale, name }}
                height={180}
                lines={[{ points, colour: "ink", width: 1.25 }]}
              />
            </Panel>
          ))}
      </div>
      {curve && (
        <PlaneMapTable
          caption={kind === "apart" ? "Its two maps (eq 8)" : "Its two maps (eq 9)"}
          maps={curve.pieces.map(({ map }) => map)}
        />
      )}
    </Frame>
  );
}

const UNIT = { min: 0, max: 1, ticks: [0, 1] };

/** What `rangeOf` looks at: the second of each two numbers. */
function swapped(flat: ArrayLike<number>): Float64Array {
  return Float64Array.from(flat, (_, i) => flat[i % 2 === 0 ? i + 1 : i - 1] ?? 0);
}

const clamp = (value: number) => Math.round(1000 * Math.min(HIGH, Math.max(LOW, value))) / 1000;
