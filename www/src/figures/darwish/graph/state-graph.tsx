import { columnsOf, MOST_DRAWN, ringPlace, type StateWay } from "./layout";
import css from "./state-graph.module.css";

const WIDTH = 360;
const KNOB = 15;
/** How far a way is bent that passes a knob. */
const PASSING = 64;
/** More knots than this leave no room for what stands at the arrows. */
const MOST_LABELLED = 6;

type Place = readonly [x: number, y: number];

interface StateGraphProps {
  /** How many states there are; the first is the one that is meant. */
  count: number;
  /** At most one from each state to each. */
  ways: readonly StateWay[];
  /** The graph in words, for those who do not see it. */
  words: string;
}

/** States as knots, and arrows between them. */
export function StateGraph({ count: states, ways: all, words }: StateGraphProps) {
  const count = Math.min(MOST_DRAWN, states);
  const few = count <= MOST_LABELLED;
  const { places, height } = few ? inColumns(columnsOf(count, all)) : onRing(count);
  const ways = all.filter(({ from, to }) => from < count && to < count);
  const back = new Set(ways.map(({ from, to }) => `${from} ${to}`));
  return (
    <svg class={css["state-graph"]} viewBox={`0 0 ${WIDTH} ${height}`} role="img" aria-label={words}>
      <defs>
        <marker
          id="state-tip"
          viewBox="0 0 8 8"
          refX={7}
          refY={4}
          markerWidth={7}
          markerHeight={7}
          orient="auto"
        >
          <path d="M0 0.8L8 4L0 7.2z" />
        </marker>
      </defs>
      {ways.map((one) => (
        <Way
          key={`${one.from} ${one.to}`}
          way={one}
          places={places}
          bend={bendOf(one, places, few, back)}
          middle={few ? null : [WIDTH / 2, height / 2]}
          labelled={few}
        />
      ))}
      {places.map(([x, y], i) => (
        <g
          key={`${i}`}
          class={`${css["state-knob"]} ${i === 0 ? css["first"] : ""}`}
          transform={`translate(${x} ${y})`}
        >
          <circle r={KNOB} />
          <text dy="0.35em" text-anchor="middle">
            {i}
          </text>
        </g>
      ))}
    </svg>
  );
}

interface Layout {
  places: Place[];
  height: number;
}

/** Each knot has room above it for the ways that lead back to it. */
const ROW = 88;

function inColumns(columns: readonly number[][]): Layout {
  const rows = Math.max(...columns.map((column) => column.length));
  // Room below for ways that pass knobs.
  const height = rows * ROW + (columns.length > 2 ? 34 : 10);
  const places: Place[] = [];
  columns.forEach((column, i) => {
    const x = columns.length === 1 ? WIDTH / 2 : 40 + (i * (WIDTH - 90)) / (columns.length - 1);
    column.forEach((index, k) => {
      places[index] = [x, (rows * ROW + 10) / 2 + (k - (column.length - 1) / 2) * ROW + 22];
    });
  });
  return { places, height };
}

function onRing(count: number): Layout {
  const height = 270;
  const places = Array.from({ length: count }, (_, i): Place => {
    const [x, y] = ringPlace(i, count, 92);
    return [WIDTH / 2 + 1.35 * x, height / 2 + y];
  });
  return { places, height };
}

interface WayProps {
  way: StateWay;
  places: readonly Place[];
  /** How far it is bent to its right. */
  bend: number;
  /** What ways back to where they came from keep away from; null: they are above. */
  middle: Place | null;
  labelled: boolean;
}

function Way({ way: { from, to, label: words }, places, bend, middle, labelled }: WayProps) {
  const [p, q] = [places[from], places[to]];
  if (!p || !q) return null;
  const { d, label } = from === to ? looped(p, middle) : led(p, q, bend);
  return (
    <g class={css["state-way"]}>
      <path d={d} marker-end="url(#state-tip)" />
      {labelled && (
        <text x={label[0]} y={label[1]} dy="0.35em" text-anchor="middle">
          {words}
        </text>
      )}
    </g>
  );
}

/** From the edge of one knob to that of another, bent to its right. */
function led([x0, y0]: Place, [x1, y1]: Place, bend: number): { d: string; label: Place } {
  const length = Math.hypot(x1 - x0, y1 - y0) || 1;
  const [ux, uy] = [(x1 - x0) / length, (y1 - y0) / length];
  const middle: Place = [(x0 + x1) / 2 - bend * uy, (y0 + y1) / 2 + bend * ux];
  const off = (from: Place): Place => {
    const away = Math.hypot(middle[0] - from[0], middle[1] - from[1]) || 1;
    const k = (KNOB + 2) / away;
    return [from[0] + k * (middle[0] - from[0]), from[1] + k * (middle[1] - from[1])];
  };
  const [start, end] = [off([x0, y0]), off([x1, y1])];
  const at = ([x, y]: Place) => `${x.toFixed(1)} ${y.toFixed(1)}`;
  // Nearer to where it begins: in the middle ways cross.
  const [near, side] = [0.45, 0.5 * bend + (bend > 0 ? 10 : -10)];
  const label: Place = [x0 + near * (x1 - x0) - side * uy, y0 + near * (y1 - y0) + side * ux];
  return { d: `M${at(start)}Q${at(middle)} ${at(end)}`, label };
}

/** A way beside another that goes the other way is bent, and so is one that passes a knob: below it. */
function bendOf(
  { from, to }: StateWay,
  places: readonly Place[],
  few: boolean,
  known: ReadonlySet<string>,
): number {
  const [p, q] = [places[from], places[to]];
  if (!p || !q || from === to) return 0;
  const passes = ([x, y]: Place) =>
    y === p[1] && y === q[1] && x > Math.min(p[0], q[0]) && x < Math.max(p[0], q[0]);
  if (few && places.some(passes)) return q[0] > p[0] ? PASSING : -PASSING;
  return known.has(`${to} ${from}`) ? 26 : 0;
}

/** Out of a knob and back, away from the middle of the drawing. */
function looped([x, y]: Place, middle: Place | null): { d: string; label: Place } {
  const angle = middle ? Math.atan2(y - middle[1], x - middle[0]) : -Math.PI / 2;
  const at = (r: number, by: number): Place => [x + r * Math.cos(angle + by), y + r * Math.sin(angle + by)];
  const text = (p: Place) => p.map((c) => c.toFixed(1)).join(" ");
  const [start, end] = [at(KNOB + 2, -0.55), at(KNOB + 2, 0.55)];
  return {
    d: `M${text(start)}C${text(at(KNOB + 38, -0.75))} ${text(at(KNOB + 38, 0.75))} ${text(end)}`,
    label: at(KNOB + 38, 0),
  };
}
