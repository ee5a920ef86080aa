import { computed } from "@preact/signals";
import { curveTime } from "#document/curve/curve";
import css from "./curve.module.css";
import { factsAlong, LOOKS } from "./facts";
import * as messages from "./messages";

const WIDTH = 300;
const HEIGHT = 64;
const TOP = 6;
const BASE = 56;

/** The least range that fills the chart: what is nearly even looks even. */
const LEAST_RANGE = 0.1;

const across = (s: number) => WIDTH * s;

const range = computed(() => {
  const all = factsAlong.value.map(({ dimension }) => dimension).filter(Number.isFinite);
  if (all.length === 0) return null;
  const [low, high] = [Math.min(...all), Math.max(...all)];
  const slack = Math.max(0, LEAST_RANGE - (high - low)) / 2;
  return {
    low,
    high,
    from: Math.max(1, low - slack),
    to: Math.max(1, low - slack) + Math.max(LEAST_RANGE, high - low),
  };
});

/** Stretches in which the curve crosses itself, as fractions of the way. */
const crossed = computed(() => {
  const step = 1 / (LOOKS - 1);
  const found: [number, number][] = [];
  factsAlong.value.forEach(({ crossings }, i) => {
    if (crossings === 0) return;
    const last = found.at(-1);
    const [from, to] = [Math.max(0, (i - 0.5) * step), Math.min(1, (i + 0.5) * step)];
    if (last && last[1] >= from - 1e-9) last[1] = to;
    else found.push([from, to]);
  });
  return found;
});

/** How rough the curve is along the way: its dimension, with the moment. */
export function Along() {
  const scale = range.value;
  const looks = factsAlong.value;
  if (!scale) return <div class={css["along"]} />;
  const up = (dimension: number) =>
    BASE - ((BASE - TOP) * (dimension - scale.from)) / (scale.to - scale.from);
  const line = looks
    .map(({ dimension }, i) => `${across(i / (LOOKS - 1)).toFixed(1)} ${up(dimension).toFixed(1)}`)
    .join("L");
  const at = across(curveTime.value);
  const here = Math.min(looks.length - 1, Math.round(curveTime.value * (LOOKS - 1)));
  const now = looks[here]?.dimension;
  return (
    <figure class={css["along"]}>
      <div class={css["along-plot"]}>
        <svg
          viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
          preserveAspectRatio="none"
          role="img"
          aria-label={messages.dimensionAlong(
            words(looks[0]?.dimension),
            words(looks.at(-1)?.dimension),
            words(scale.low),
            words(scale.high),
          )}
        >
          {crossed.value.map(([from, to]) => (
            <rect
              key={from}
              class={css["along-crossed"]}
              x={across(from)}
              y={0}
              width={across(to - from)}
              height={BASE}
            />
          ))}
          <path class={css["along-base"]} d={`M0 ${BASE}H${WIDTH}`} />
          <path class={css["along-line"]} d={`M${line}`} />
          <path class={css["along-now"]} d={`M${at} 0V${BASE}`} />
        </svg>
        {now !== undefined && (
          <span
            class={css["along-dot"]}
            aria-hidden="true"
            style={{ left: `${100 * curveTime.value}%`, top: `${(100 * up(now)) / HEIGHT}%` }}
          />
        )}
      </div>
      <figcaption>
        <span>{messages.dimensionAtA(words(looks[0]?.dimension))}</span>
        <span>{crossed.value.length > 0 ? messages.shadedCrossesItself : ""}</span>
        <span>{looks.length === LOOKS && `B ${words(looks.at(-1)?.dimension)}`}</span>
      </figcaption>
    </figure>
  );
}

function words(dimension: number | undefined): string {
  return dimension === undefined ? "unknown" : dimension.toFixed(2);
}
