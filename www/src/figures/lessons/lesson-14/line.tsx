import css from "./line.module.css";

const [WIDTH, HEIGHT, MARGIN] = [440, 90, 20];
const LONG = 10;
/** The height of the line, in units of the drawing. */
const GROUND = 60;
const left = (x: number) => MARGIN + ((WIDTH - 2 * MARGIN) * x) / LONG;

interface LineProps {
  /** Numbers that are followed. */
  from: readonly number[];
  map: (x: number) => number;
  /** How many steps of each are seen. */
  steps: number;
}

/** Numbers on a ruler, and in arcs where a map takes them step by step. */
export function Line({ from, map, steps }: LineProps) {
  const ways = from.map((start) => {
    const way = [start];
    for (let i = 0; i < steps; i++) way.push(map(way[i] ?? 0));
    return way;
  });
  const said = ways.map((way) => way.map((place) => place.toFixed(2)).join(" to ")).join(", and ");
  return (
    <svg
      class={css["line"]}
      viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
      role="img"
      aria-label={`A ruler from 0 to ${LONG}, and on it the way from ${said}.`}
    >
      <path class={css["ruler"]} d={`M${left(0)} ${GROUND}H${left(LONG)}`} />
      {Array.from({ length: LONG + 1 }, (_, x) => (
        <g key={x}>
          <path class={css["ruler"]} d={`M${left(x)} ${GROUND}v6`} />
          <text x={left(x)} y={GROUND + 22} text-anchor="middle">
            {x}
          </text>
        </g>
      ))}
      {ways.map((way) => (
        <g key={way[0]}>
          <path
            class={css["arcs"]}
            d={way
              .slice(1)
              .map((to, i) => arc(way[i] ?? 0, to))
              .join("")}
          />
          {way.map((place, i) => (
            <circle
              key={`${i + 1}`}
              class={i === 0 ? css["origin"] : css["step"]}
              cx={left(place)}
              cy={GROUND}
              r={i === 0 ? 6 : 4}
            />
          ))}
        </g>
      ))}
    </svg>
  );
}

/** From one number to another, over the ruler. */
function arc(from: number, to: number): string {
  const [a, b] = [left(from), left(to)];
  const wide = Math.abs(b - a) / 2;
  return `M${a.toFixed(1)} ${GROUND}A${wide} ${wide / 1.2} 0 0 ${b > a ? 1 : 0} ${b.toFixed(1)} ${GROUND}`;
}
