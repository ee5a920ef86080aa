import css from "./graph.module.css";

export interface GraphProps {
  /** A node for each, numbered from 1. */
  count: number;
  /** Directions, in radians, in which they lie from the middle: neighbours stay neighbours. */
  angles: readonly number[];
  edges: readonly (readonly [number, number])[];
  colours: readonly string[];
  /** What it shows, in words. */
  label: string;
}

const SIDE = 150;
const MIDDLE = SIDE / 2;

/** Nodes in a ring, joined where two belong together. Each has its number and a pattern beside its colour. */
export function Graph({ count, angles, edges, colours, label }: GraphProps) {
  const knob = Math.min(17, (0.55 * Math.PI * 55) / Math.max(1, count));
  const places = count === 1 ? [[MIDDLE, MIDDLE] as const] : evenPlaces(angles, MIDDLE - knob - 3);
  return (
    <svg class={css["graph-drawing"]} viewBox={`0 0 ${SIDE} ${SIDE}`} role="img" aria-label={label}>
      {edges.map(([i, j]) => {
        const [x1, y1] = places[i] ?? [MIDDLE, MIDDLE];
        const [x2, y2] = places[j] ?? [MIDDLE, MIDDLE];
        return <path key={`${i} ${j}`} d={`M${x1} ${y1}L${x2} ${y2}`} />;
      })}
      {places.map(([x, y], i) => (
        <Node key={i} x={x} y={y} radius={knob} index={i} colour={colours[i % colours.length] ?? "gray"} />
      ))}
    </svg>
  );
}

interface NodeProps {
  x: number;
  y: number;
  radius: number;
  index: number;
  colour: string;
}

function Node({ x, y, radius, index, colour }: NodeProps) {
  return (
    <g transform={`translate(${x.toFixed(2)} ${y.toFixed(2)}) scale(${(radius / 17).toFixed(3)})`}>
      <circle class={css["node-ground"]} r={17} style={{ stroke: colour }} />
      <path
        class={css["node-pattern"]}
        d={PATTERNS[index % PATTERNS.length] ?? ""}
        style={{ stroke: colour }}
      />
      {radius >= 6 && (
        <text dy="0.35em" text-anchor="middle">
          {index + 1}
        </text>
      )}
    </g>
  );
}

/** Lines in a disc of radius 17, of another direction or rhythm for each of eight colours. */
const PATTERNS: readonly string[] = [
  hatch(0, 5),
  hatch(90, 5),
  hatch(45, 5),
  hatch(135, 5),
  `${hatch(0, 8)}${hatch(90, 8)}`,
  `${hatch(45, 8)}${hatch(135, 8)}`,
  hatch(20, 9),
  "M0-5a5 5 0 1 1-.01 0M0-11a11 11 0 1 1-.01 0",
];

function hatch(degrees: number, step: number): string {
  const angle = (degrees * Math.PI) / 180;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  let path = "";
  for (let offset = -15 + (30 % step) / 2; offset <= 15; offset += step) {
    const half = Math.sqrt(Math.max(0, 16 * 16 - offset * offset));
    const at = (s: number) => `${(s * cos - offset * sin).toFixed(1)} ${(s * sin + offset * cos).toFixed(1)}`;
    path += `M${at(-half)}L${at(half)}`;
  }
  return path;
}

/** Round a ring at even steps, in the order of the directions and turned to lie as near to them as can be. */
export function evenPlaces(angles: readonly number[], ring: number): [number, number][] {
  const order = angles.map((_, i) => i).sort((i, j) => (angles[i] ?? 0) - (angles[j] ?? 0));
  const start = meanAngle(order.map((i, rank) => (angles[i] ?? 0) - (2 * Math.PI * rank) / angles.length));
  const places: [number, number][] = angles.map(() => [MIDDLE, MIDDLE]);
  for (const [rank, i] of order.entries()) {
    const at = start + (2 * Math.PI * rank) / angles.length;
    places[i] = [MIDDLE + ring * Math.cos(at), MIDDLE - ring * Math.sin(at)];
  }
  return places;
}

function meanAngle(angles: readonly number[]): number {
  const sum = (f: (angle: number) => number) => angles.reduce((all, angle) => all + f(angle), 0);
  return Math.atan2(sum(Math.sin), sum(Math.cos));
}
