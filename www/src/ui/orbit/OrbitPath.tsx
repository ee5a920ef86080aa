import type { Point } from "#geometry/maps/orbit";
import css from "./orbit.module.css";

interface OrbitPathProps {
  points: readonly Point[];
  /** The map of each step. */
  letters: readonly number[];
  colours: readonly string[];
  /** From the plane to what it is drawn on. */
  place: (point: Point) => readonly [x: number, y: number];
  /** Steps go back through pieces, by inverses: they are dashed. */
  inverse?: boolean;
  /** Whether steps before the latest are kept as dots. */
  trail?: boolean;
  /** How large it is drawn. */
  size?: number;
}

/** So many of the latest steps are drawn as ways, with their numbers: more could not be told apart. */
const WAYS = 6;
/** Where there is less room than this, in units of the drawing, no number is put on a way. */
const ROOM = 34;
/** What is far outside is as good as at the edge of what can be drawn. */
const FAR = 1e5;

/** A point that is followed: its steps are numbered, and each has the colour and the number of its map. */
export function OrbitPath(props: OrbitPathProps) {
  const { points, letters, colours, place, inverse = false, trail = true, size = 1 } = props;
  const colourOf = (letter: number) => colours[letter % Math.max(1, colours.length)] ?? "currentColor";
  const near = (x: number) => (Number.isFinite(x) ? Math.min(FAR, Math.max(-FAR, x)) : FAR);
  const placed = points.map((point): Point => {
    const [x, y] = place(point);
    return [near(x), near(y)];
  });
  const first = Math.max(0, placed.length - 1 - WAYS);
  const recent = placed.slice(first);
  const steps = recent.slice(1).map((to, i) => {
    const from = recent[i] ?? to;
    const letter = letters[first + i] ?? 0;
    return { from, to, letter, index: first + i, ...bow(from, to) };
  });
  return (
    <g class={css["orbit"]} style={{ "--orbit-size": String(size) }}>
      {trail && first > 0 && <Trail points={placed.slice(0, first)} letters={letters} colourOf={colourOf} />}
      {steps.map(({ index, path }) => (
        <path key={index} class={css["orbit-halo"]} d={path} />
      ))}
      {steps.map(({ index, path, letter }) => (
        <path
          key={index}
          class={`${css["orbit-way"]} ${inverse ? css["orbit-inverse"] : ""}`}
          style={{ stroke: colourOf(letter) }}
          d={path}
        />
      ))}
      {recent.map(([x, y], i) => {
        const isHere = i === recent.length - 1;
        const letter = first + i === 0 ? null : (letters[first + i - 1] ?? null);
        return (
          <circle
            key={first + i}
            class={isHere ? css["orbit-here"] : css["orbit-dot"]}
            style={letter === null ? {} : { fill: colourOf(letter) }}
            cx={x.toFixed(1)}
            cy={y.toFixed(1)}
            r={(isHere ? 6 : 4) * size}
          />
        );
      })}
      {steps.map(
        ({ index, letter, middle: [x, y], long }) =>
          long > ROOM * size && (
            <g key={index} transform={`translate(${x.toFixed(1)} ${y.toFixed(1)})`}>
              <circle class={css["orbit-map"]} r={9 * size} style={{ stroke: colourOf(letter) }} />
              <text class={css["orbit-letter"]} dy="0.35em">
                {letter + 1}
              </text>
            </g>
          ),
      )}
      {recent.map(([x, y], i) => {
        const before = recent[i - 1];
        // A point that a map keeps in place has the number of its latest step only.
        const next = recent[i + 1];
        if (next && apart(next, [x, y]) < 12 * size) return null;
        // On the side that its way does not come from.
        const left = before !== undefined && before[0] > x;
        return (
          <text
            key={first + i}
            class={css["orbit-count"]}
            x={(x + (left ? -8 : 8) * size).toFixed(1)}
            y={(y - 7 * size).toFixed(1)}
            text-anchor={left ? "end" : "start"}
          >
            {first + i}
          </text>
        );
      })}
    </g>
  );
}

const apart = ([x, y]: Point, [u, v]: Point): number => Math.hypot(x - u, y - v);

/** How far an arc stands off its chord, so that a way there and one back are two. */
const BOW = 0.14;

function bow([x, y]: Point, [u, v]: Point): { path: string; middle: Point; long: number } {
  const [dx, dy] = [u - x, v - y];
  const control: Point = [(x + u) / 2 + 2 * BOW * dy, (y + v) / 2 - 2 * BOW * dx];
  const at = (p: Point) => `${p[0].toFixed(1)} ${p[1].toFixed(1)}`;
  return {
    path: `M${at([x, y])}Q${at(control)} ${at([u, v])}`,
    middle: [(x + u) / 2 + BOW * dy, (y + v) / 2 - BOW * dx],
    long: Math.hypot(dx, dy),
  };
}

/** Where the point was before, as dots in the colours of the maps that led there: one path a map. */
function Trail({
  points,
  letters,
  colourOf,
}: {
  points: readonly Point[];
  letters: readonly number[];
  colourOf: (letter: number) => string;
}) {
  const dots = new Map<number, string[]>();
  for (const [i, [x, y]] of points.entries()) {
    const letter = i === 0 ? -1 : (letters[i - 1] ?? -1);
    dots.set(letter, [...(dots.get(letter) ?? []), `M${x.toFixed(1)} ${y.toFixed(1)}h0`]);
  }
  return (
    <>
      {/* A dot on a piece of its own colour is seen by what is around it. */}
      <path class={css["orbit-trail-halo"]} d={[...dots.values()].flat().join("")} />
      {[...dots].map(([letter, all]) => (
        <path
          key={letter}
          class={css["orbit-trail"]}
          style={letter < 0 ? {} : { stroke: colourOf(letter) }}
          d={all.join("")}
        />
      ))}
    </>
  );
}

/** The frame of a cell that is to be reached. */
export function Cell({ corners, place, reached }: CellProps) {
  const d = `M${corners
    .map((corner) => place(corner))
    .map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`)
    .join("L")}Z`;
  return (
    <g class={css["orbit"]}>
      <path class={css["cell-halo"]} d={d} />
      <path class={`${css["cell"]} ${reached ? css["cell-reached"] : ""}`} d={d} />
    </g>
  );
}

interface CellProps extends Pick<OrbitPathProps, "place"> {
  corners: readonly Point[];
  reached: boolean;
}
