import { useRef } from "preact/hooks";
import { dark } from "#document/preferences";
import { fixed } from "#format/numbers";
import { palette } from "#style/palette";
import { useWidth } from "../picture/canvas";
import { common, cover, type Round } from "./barnsley";
import css from "./barnsley-rows.module.css";

/** The part of the line that is drawn: all of [0, 1], and so much of what reaches beyond. */
const LEFT = -0.57;
const RIGHT = 1.06;
const ROW = 50;
const BAR = 14;

interface RowsProps {
  rounds: readonly Round[];
  r: number;
  /** For the index: no words, no numbers. */
  bare?: boolean;
}

/** One line for each iteration: the points of both pieces, and how far the pieces may reach from them. */
export function Rows({ rounds, r, bare = false }: RowsProps) {
  const host = useRef<HTMLDivElement>(null);
  const width = useWidth(host);
  const row = bare ? 22 : ROW;
  const height = row * rounds.length + (bare ? 0 : ROW + 18);
  return (
    <div class={css["rows"]} ref={host} style={{ "--rows-height": `${height}px` }}>
      {width > 0 && (
        <svg
          width={width}
          height={height}
          viewBox={`0 0 ${width} ${height}`}
          role="img"
          aria-hidden={bare}
          aria-label={words(rounds, r)}
        >
          <Patterns />
          {!bare && <Limit r={r} y={rounds.length * row} width={width} />}
          {rounds.map((round, i) => (
            <Row key={round.n} round={round} y={i * row} width={width} bare={bare} />
          ))}
        </svg>
      )}
    </div>
  );
}

function words(rounds: readonly Round[], r: number): string {
  const last = rounds.at(-1);
  if (!last) return "Nothing computed yet.";
  const verdict = last.apart ? "so the dust is proved disconnected" : "so nothing is proved";
  return (
    `The points of both pieces after each of ${rounds.length} iterations at r = ${fixed(r, 3)}. In the last they are ` +
    `${fixed(last.distance, 4)} apart, the bound is ${fixed(last.bound, 4)}, ${verdict}.`
  );
}

/** Stripes for where the reaches of both pieces overlap, so that it is not only a third colour. */
function Patterns() {
  return (
    <defs>
      <pattern
        id="both-reach"
        width={6}
        height={6}
        patternUnits="userSpaceOnUse"
        patternTransform="rotate(45)"
      >
        <path d="M0 3H6" class={css["stripe"]} />
      </pattern>
    </defs>
  );
}

/** The dust itself, for comparison, and where 0 and 1 are. */
function Limit({ r, y, width }: { r: number; y: number; width: number }) {
  const colours = palette(dark.value ? "dark" : "light");
  const x = (value: number) => ((value - LEFT) / (RIGHT - LEFT)) * width;
  return (
    <g>
      {[0, 1].map((at) => (
        <g key={at}>
          <path class={css["row-guide"]} d={`M${x(at)} 24V${y + 30 + BAR}`} />
          <text class={css["row-text"]} x={x(at)} y={y + 44 + BAR} text-anchor="middle">
            {at}
          </text>
        </g>
      ))}
      <text class={`${css["row-text"]} ${css["strong"]}`} x={0} y={y + 18}>
        the dust itself
      </text>
      {[0, 1].map((piece) => (
        <path
          key={piece}
          class={css["row-dust"]}
          style={{ color: colours[piece] }}
          d={intervals(r, piece, width)
            .map(
              ([from, to]) =>
                `M${x(from).toFixed(2)} ${y + 28}H${x(to).toFixed(2)}v${BAR}H${x(from).toFixed(2)}Z`,
            )
            .join("")}
        />
      ))}
    </g>
  );
}

/** The intervals of one piece, split until they are finer than what a screen shows. */
function intervals(r: number, piece: number, width: number): [number, number][] {
  let parts: [number, number][] = [[0, 1]];
  const finest = 1 / Math.max(100, width);
  for (let length = 1; r < 0.5 && length * r > finest && parts.length < 256; length *= r) {
    parts = parts.flatMap(([from, to]): [number, number][] => [
      [r * from, r * to],
      [r * from + 1 - r, r * to + 1 - r],
    ]);
  }
  return parts.map(([from, to]) => [r * from + piece * (1 - r), r * to + piece * (1 - r)]);
}

function Row({ round, y, width, bare }: { round: Round; y: number; width: number; bare: boolean }) {
  const colours = palette(dark.value ? "dark" : "light");
  const x = (value: number) => ((value - LEFT) / (RIGHT - LEFT)) * width;
  const bars = round.pieces.map((points) => cover(points, round.reach));
  const top = bare ? 3 : 28;
  const box = (p: readonly [number, number], inset = 0) => {
    const [from, to] = [Math.max(0, x(p[0])), Math.min(width, x(p[1]))];
    return `M${from.toFixed(1)} ${top + inset}H${to.toFixed(1)}V${top + BAR - inset}H${from.toFixed(1)}Z`;
  };
  const both = common(bars[0] ?? [], bars[1] ?? []);
  return (
    <g transform={`translate(0 ${y})`}>
      {!bare && (
        <>
          <text class={`${css["row-text"]} ${css["strong"]}`} x={0} y={18}>
            n = {round.n}
          </text>
          <text
            class={`${css["row-text"]} ${round.apart ? css["apart"] : ""}`}
            x={width}
            y={18}
            text-anchor="end"
          >
            d {fixed(round.distance, 4)} {round.apart ? ">" : "≤"} {fixed(round.bound, 4)}
            {round.apart ? ", apart" : ""}
          </text>
        </>
      )}
      {round.pieces.map((points, i) => (
        <g key={points[0]} style={{ color: colours[i] }}>
          <path class={css["row-reach"]} d={(bars[i] ?? []).map((bar) => box(bar)).join("")} />
          <path class={css["row-points"]} d={ticks(points, x, top)} />
        </g>
      ))}
      <path class={css["row-both"]} d={both.map((bar) => box(bar)).join("")} />
      {round.apart && !bare && (
        <path class={css["row-gap"]} d={`M${x(round.nearest[0])} ${top + BAR / 2}H${x(round.nearest[1])}`} />
      )}
    </g>
  );
}

/** A short upright line for each point; points that fall on the same half pixel are one. */
function ticks(points: readonly number[], x: (value: number) => number, top: number): string {
  const places = new Set(points.map((point) => (Math.round(2 * x(point)) / 2).toFixed(1)));
  return [...places].map((place) => `M${place} ${top}V${top + BAR}`).join("");
}
