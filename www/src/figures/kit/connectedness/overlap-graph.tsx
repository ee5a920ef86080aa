import { dark } from "#document/preferences";
import { palette } from "#style/palette";
import { type Edge, groups } from "./collisions";
import css from "./overlap-graph.module.css";

export interface GraphProps {
  /** A vertex for each map. */
  count: number;
  /** Directions, in radians, in which the pieces lie from the middle: neighbours stay neighbours. */
  angles: readonly number[];
  edges: readonly Edge[];
  /** Edges that somebody expects, drawn dashed: there may be others, and they may not be there. */
  expected?: readonly Pair[];
  /** Whether the newest edge is told from the others. */
  still?: boolean;
}

type Pair = readonly [i: number, j: number];

const SIDE = 240;
const RING = 86;
const KNOB = 16;

/** The attractorlet-overlap graph as it stands, the newest edge drawn strongest. */
export function Graph({ count, angles, edges, expected = [], still = false }: GraphProps) {
  const colours = palette(dark.value ? "dark" : "light");
  const places = evenPlaces(angles);
  const newest = still ? undefined : edges.at(-1);
  const line = ([i, j]: Pair) => {
    const [[x1, y1], [x2, y2]] = [places[i] ?? [0, 0], places[j] ?? [0, 0]];
    return `M${x1} ${y1}L${x2} ${y2}`;
  };
  return (
    <svg
      class={css["graph"]}
      viewBox={`0 0 ${SIDE} ${SIDE}`}
      role="img"
      aria-label={graphWords(count, edges, expected)}
    >
      {edges.map((edge) => (
        <path key={edge.between.join()} class={edge === newest ? css["newest"] : ""} d={line(edge.between)} />
      ))}
      {expected.map((pair) => (
        <path key={`expected ${pair.join()}`} class={css["expected"]} d={line(pair)} />
      ))}
      {places.map(([x, y], i) => (
        <g key={`${i + 1}`} transform={`translate(${x} ${y})`} style={{ color: colours[i % colours.length] }}>
          <circle r={KNOB} />
          <text dy="0.35em" text-anchor="middle">
            {i + 1}
          </text>
        </g>
      ))}
    </svg>
  );
}

/** Round a ring at even steps, in the order of the directions and turned to lie as near to them as can be. */
function evenPlaces(angles: readonly number[]): [number, number][] {
  const order = angles.map((_, i) => i).sort((i, j) => (angles[i] ?? 0) - (angles[j] ?? 0));
  const start = meanAngle(order.map((i, rank) => (angles[i] ?? 0) - (2 * Math.PI * rank) / angles.length));
  const places: [number, number][] = angles.map(() => [SIDE / 2, SIDE / 2]);
  for (const [rank, i] of order.entries()) {
    const at = start + (2 * Math.PI * rank) / angles.length;
    places[i] = [SIDE / 2 + RING * Math.cos(at), SIDE / 2 - RING * Math.sin(at)];
  }
  return places;
}

function meanAngle(angles: readonly number[]): number {
  const sum = (f: (angle: number) => number) => angles.reduce((all, angle) => all + f(angle), 0);
  return Math.atan2(sum(Math.sin), sum(Math.cos));
}

function graphWords(count: number, edges: readonly Edge[], expected: readonly Pair[]): string {
  const found = groups(
    count,
    edges.map((edge) => edge.between),
  );
  const listed = edges.map(({ between: [i, j] }) => `${i + 1} with ${j + 1}`).join(", ");
  if (edges.length === 0 && expected.length > 0) {
    return `Your graph of ${count} pieces: ${expected.map(([i, j]) => `${i + 1} with ${j + 1}`).join(", ")}.`;
  }
  return `Overlap graph of ${count} pieces: ${listed || "no edges"}; ${found.count} group${found.count === 1 ? "" : "s"}.`;
}
